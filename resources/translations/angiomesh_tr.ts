<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>CasePorts</name>
    <message>
        <source>left out of the surface with the part that it ends</source>
        <translation>bitirdiği parçayla birlikte yüzeyin dışında kaldı</translation>
    </message>
    <message>
        <source>made</source>
        <translation>yapıldı</translation>
    </message>
    <message>
        <source>run to make it</source>
        <translation>yapmak için çalıştır</translation>
    </message>
    <message>
        <source>at the volume&apos;s border</source>
        <translation>hacim sınırında</translation>
    </message>
    <message>
        <source>cut automatically</source>
        <translation>otomatik kesildi</translation>
    </message>
    <message>
        <source>slices its vessel: %1° off its axis, %2 times its section; Cut across ends it just inside</source>
        <translation>damarını eğik kesiyor: eksenden sapma %1°, en kesitin %2 katı; Dik kes damarı hemen içeride bitirir</translation>
    </message>
    <message>
        <source>being looked at</source>
        <translation>inceleniyor</translation>
    </message>
    <message>
        <source>run to Evolve to see where it lies</source>
        <translation>yeri için Evrim adımına kadar çalıştırın</translation>
    </message>
    <message>
        <source>, in the last mesh</source>
        <translation>, son ağda</translation>
    </message>
</context>
<context>
    <name>MeshFormat</name>
    <message>
        <source>STL keeps no topology: each triangle stands by itself, and its points have to be merged again on import.</source>
        <translation>STL topoloji saklamaz: her üçgen tek başına durur, noktalarının içe aktarırken yeniden birleştirilmesi gerekir.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>1/eta of eq. 4.2: the wanted edge length grows by at most 1 - 1/eta per length</source>
        <translation>denk. 4.2&apos;deki 1/eta: istenen kenar uzunluğu, birim uzunlukta en çok 1 - 1/eta kadar büyür</translation>
    </message>
    <message>
        <source>Accuracy from ρ only</source>
        <translation>Doğruluk yalnız ρ ile</translation>
    </message>
    <message>
        <source>Accuracy ρ</source>
        <translation>Doğruluk ρ</translation>
    </message>
    <message>
        <source>At the border</source>
        <translation>Sınırda</translation>
    </message>
    <message>
        <source>Automatic seeds</source>
        <translation>Otomatik tohumlar</translation>
    </message>
    <message>
        <source>Best voxels taken</source>
        <translation>Alınan en iyi voksel</translation>
    </message>
    <message>
        <source>Bone above</source>
        <translation>Kemik eşiği</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Hücre boyu</translation>
    </message>
    <message>
        <source>Check every</source>
        <translation>Denetim adımı</translation>
    </message>
    <message>
        <source>Contour: RMS change</source>
        <translation>Kontur: RMS değişim</translation>
    </message>
    <message>
        <source>Contour: advection</source>
        <translation>Kontur: adveksiyon</translation>
    </message>
    <message>
        <source>Contour: curvature</source>
        <translation>Kontur: eğrilik</translation>
    </message>
    <message>
        <source>Contour: iterations</source>
        <translation>Kontur: yineleme</translation>
    </message>
    <message>
        <source>Contour: propagation</source>
        <translation>Kontur: ilerleme</translation>
    </message>
    <message>
        <source>Contour: scale</source>
        <translation>Kontur: ölçek</translation>
    </message>
    <message>
        <source>Contour: α</source>
        <translation>Kontur: α</translation>
    </message>
    <message>
        <source>Contour: β</source>
        <translation>Kontur: β</translation>
    </message>
    <message>
        <source>Contrast from</source>
        <translation>Kontrast ölçüsü</translation>
    </message>
    <message>
        <source>Cubic voxels</source>
        <translation>Kübik vokseller</translation>
    </message>
    <message>
        <source>Cut across at the border</source>
        <translation>Sınırda dik kes</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Kesimler</translation>
    </message>
    <message>
        <source>Edges around</source>
        <translation>Damar çevresinde kenar</translation>
    </message>
    <message>
        <source>Ends cut at</source>
        <translation>Uç kesim yeri</translation>
    </message>
    <message>
        <source>Even sizes 1/η</source>
        <translation>Eşit boyut 1/η</translation>
    </message>
    <message>
        <source>Finest edge</source>
        <translation>En ince kenar</translation>
    </message>
    <message>
        <source>Follow image γ</source>
        <translation>Görüntüyü izle γ</translation>
    </message>
    <message>
        <source>Grow back by μ</source>
        <translation>Geri büyüt μ</translation>
    </message>
    <message>
        <source>Interpolant</source>
        <translation>İnterpolant</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Yinelemeler</translation>
    </message>
    <message>
        <source>Keep apart up to k</source>
        <translation>Ayrı tutma sınırı k</translation>
    </message>
    <message>
        <source>Keep blobs β</source>
        <translation>Yumru koruma β</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiket</translation>
    </message>
    <message>
        <source>Largest b</source>
        <translation>En çok b</translation>
    </message>
    <message>
        <source>Least b</source>
        <translation>En az b</translation>
    </message>
    <message>
        <source>Lumen limit</source>
        <translation>En az lümen parlaklığı</translation>
    </message>
    <message>
        <source>Least component</source>
        <translation>En küçük bileşen</translation>
    </message>
    <message>
        <source>Least length</source>
        <translation>En az uzunluk</translation>
    </message>
    <message>
        <source>Least part without a seed</source>
        <translation>Tohumsuz en küçük parça</translation>
    </message>
    <message>
        <source>Least vesselness</source>
        <translation>En az damarsılık</translation>
    </message>
    <message>
        <source>Least vesselness b</source>
        <translation>En az damarsılık b</translation>
    </message>
    <message>
        <source>Least volume</source>
        <translation>En az hacim</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>En uzun kenar</translation>
    </message>
    <message>
        <source>Lowest intensity</source>
        <translation>En düşük yoğunluk</translation>
    </message>
    <message>
        <source>Lumen mean, steps</source>
        <translation>Lümen ortalaması, adım</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Yöntem</translation>
    </message>
    <message>
        <source>Stretch, middle</source>
        <translation>Germe ortası</translation>
    </message>
    <message>
        <source>Most iterations</source>
        <translation>En çok yineleme</translation>
    </message>
    <message>
        <source>Most triangles</source>
        <translation>En çok üçgen</translation>
    </message>
    <message>
        <source>Names of ports</source>
        <translation>Açıklık adları</translation>
    </message>
    <message>
        <source>Noise removal per step</source>
        <translation>Adım başına gürültü giderme</translation>
    </message>
    <message>
        <source>Noise removal, steps</source>
        <translation>Gürültü giderme, adım</translation>
    </message>
    <message>
        <source>Parts kept</source>
        <translation>Tutulan parça</translation>
    </message>
    <message>
        <source>Parts ticked off</source>
        <translation>Çıkarılan parçalar</translation>
    </message>
    <message>
        <source>Pass one-voxel vessels</source>
        <translation>Tek voksellik damarda ilerle</translation>
    </message>
    <message>
        <source>Point spread</source>
        <translation>Nokta yayılımı</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Yarıçap</translation>
    </message>
    <message>
        <source>Thin vessels d</source>
        <translation>İnce damarlara erişim d</translation>
    </message>
    <message>
        <source>Reach of the wall</source>
        <translation>Duvar arama mesafesi</translation>
    </message>
    <message>
        <source>Region of interest</source>
        <translation>İlgi bölgesi</translation>
    </message>
    <message>
        <source>Region: iterations</source>
        <translation>Bölge: yineleme</translation>
    </message>
    <message>
        <source>Region: multiplier</source>
        <translation>Bölge: çarpan</translation>
    </message>
    <message>
        <source>Region: radius</source>
        <translation>Bölge: yarıçap</translation>
    </message>
    <message>
        <source>Reject noise c</source>
        <translation>Gürültüyü ele c</translation>
    </message>
    <message>
        <source>Reject noise, share of contrast</source>
        <translation>Gürültüyü ele, kontrast payı</translation>
    </message>
    <message>
        <source>Reject plates α</source>
        <translation>Levhaları ele α</translation>
    </message>
    <message>
        <source>Relax bends</source>
        <translation>Büküm gevşetme</translation>
    </message>
    <message>
        <source>Remove noise</source>
        <translation>Gürültü gider</translation>
    </message>
    <message>
        <source>Rim of bone</source>
        <translation>Kemik çeperi</translation>
    </message>
    <message>
        <source>Seeds by hand</source>
        <translation>Elle tohumlar</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>En kısa kenar</translation>
    </message>
    <message>
        <source>Sizes from the image</source>
        <translation>Boyutlar görüntüden</translation>
    </message>
    <message>
        <source>Sizes looked for</source>
        <translation>Aranan boyutlar</translation>
    </message>
    <message>
        <source>Smooth by λ</source>
        <translation>Yumuşatma λ</translation>
    </message>
    <message>
        <source>Smooth wall</source>
        <translation>Düzgün duvar</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Yumuşatma</translation>
    </message>
    <message>
        <source>Smoothing across</source>
        <translation>Enine yumuşatma</translation>
    </message>
    <message>
        <source>Smoothing along</source>
        <translation>Boyuna yumuşatma</translation>
    </message>
    <message>
        <source>Smoothness of the wall</source>
        <translation>Duvar düzgünlüğü</translation>
    </message>
    <message>
        <source>Spacing of the sizes</source>
        <translation>Boyut aralığı</translation>
    </message>
    <message>
        <source>Specificity ξ</source>
        <translation>Özgüllük ξ</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Başlangıç</translation>
    </message>
    <message>
        <source>Stay near the wall</source>
        <translation>Duvara yakın kal</translation>
    </message>
    <message>
        <source>Step of the front</source>
        <translation>Cephe adımı</translation>
    </message>
    <message>
        <source>Stop after</source>
        <translation>Durma noktası</translation>
    </message>
    <message>
        <source>Stretch the vessels&apos; greys</source>
        <translation>Damar grilerini ger</translation>
    </message>
    <message>
        <source>Thickest vessel</source>
        <translation>En kalın damar</translation>
    </message>
    <message>
        <source>Thinnest vessel</source>
        <translation>En ince damar</translation>
    </message>
    <message>
        <source>Threshold: Gaussian</source>
        <translation>Eşik: Gauss</translation>
    </message>
    <message>
        <source>Threshold: from the seeds</source>
        <translation>Eşik: tohumlardan</translation>
    </message>
    <message>
        <source>Threshold: lower</source>
        <translation>Eşik: alt</translation>
    </message>
    <message>
        <source>Threshold: upper</source>
        <translation>Eşik: üst</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Tolerance, delta</source>
        <translation>Tolerans, delta</translation>
    </message>
    <message>
        <source>Vesselness measure</source>
        <translation>Damarsılık ölçüsü</translation>
    </message>
    <message>
        <source>Vessels are</source>
        <translation>Damarlar</translation>
    </message>
    <message>
        <source>Voxels joined by</source>
        <translation>Voksel komşuluğu</translation>
    </message>
    <message>
        <source>Wall from the image</source>
        <translation>Duvar görüntüden</translation>
    </message>
    <message>
        <source>Stretch, width</source>
        <translation>Germe genişliği</translation>
    </message>
    <message>
        <source>a contour that has not come to rest goes on</source>
        <translation>durulmamış bir kontur ilerlemeyi sürdürür</translation>
    </message>
    <message>
        <source>a front that has not come to rest goes on</source>
        <translation>durulmamış bir cephe ilerlemeyi sürdürür</translation>
    </message>
    <message>
        <source>accuracy: the angle that an edge subtends on the osculating circle, eq. 4.1, down to edgeMinVoxels</source>
        <translation>doğruluk: bir kenarın oskülatör çemberde karşıladığı açı, denk. 4.1; edgeMinVoxels sınırına kadar</translation>
    </message>
    <message>
        <source>advancing-front: triangles of the wanted size, made on phi = 0 itself; marching-cubes: the triangles of each cell; remesh: marching cubes, remeshed to the wanted size</source>
        <translation>advancing-front: istenen boyutta, doğrudan phi = 0 üzerinde üretilen üçgenler; marching-cubes: her hücrenin üçgenleri; remesh: marching cubes, istenen boyuta yeniden ağlanmış</translation>
    </message>
    <message>
        <source>also move the front in vessels and gaps one voxel wide, where upwind differences vanish</source>
        <translation>cepheyi, rüzgâr yönlü farkların sıfırlandığı bir voksel genişliğindeki damar ve aralıklarda da ilerletir</translation>
    </message>
    <message>
        <source>b from</source>
        <translation>b kaynağı</translation>
    </message>
    <message>
        <source>blobs, branchings and aneurysms get more</source>
        <translation>yumrular, dallanmalar ve anevrizmalar daha yüksek değer alır</translation>
    </message>
    <message>
        <source>bone&apos;s blurred edge goes, and vessels that touch it get thinner</source>
        <translation>kemiğin bulanık kenarı gider, ona değen damarlar incelir</translation>
    </message>
    <message>
        <source>brighter voxels count as bone, calcium or metal; they and a rim around them are filled with the median intensity between the bounds; none: no upper bound</source>
        <translation>daha parlak vokseller kemik, kalsiyum veya metal sayılır; bunlar ve çevrelerindeki çeper, sınırlar arasındaki medyan yoğunlukla doldurulur; none: üst sınır yok</translation>
    </message>
    <message>
        <source>c as a fraction of the contrast</source>
        <translation>kontrastın bir kesri olarak c</translation>
    </message>
    <message>
        <source>centre of the sigmoid, as the viewer&apos;s level; auto: middle of the percentiles</source>
        <translation>sigmoidin merkezi, görüntüleyicinin seviyesi gibi; auto: yüzdeliklerin ortası</translation>
    </message>
    <message>
        <source>components smaller than this are left out</source>
        <translation>bundan küçük bileşenler dışarıda bırakılır</translation>
    </message>
    <message>
        <source>components with centre lines shorter than this, all branches together, are left out; so is what is not longer than it is thick</source>
        <translation>merkez hatları, tüm dallarla birlikte, bundan kısa olan bileşenler dışarıda bırakılır; boyu kalınlığından uzun olmayanlar da</translation>
    </message>
    <message>
        <source>contrast: b = 0.007 xi; average: eq. 3.20, clamped to bMin..bMax</source>
        <translation>contrast: b = 0.007 xi; average: denk. 3.20, bMin..bMax aralığıyla sınırlı</translation>
    </message>
    <message>
        <source>converged below this change per inside voxel between checks</source>
        <translation>denetimler arasında iç voksel başına değişim bunun altındaysa yakınsamış sayılır</translation>
    </message>
    <message>
        <source>converged only if the change also differs from the previous one by less than this</source>
        <translation>ancak değişimin öncekinden farkı da bundan azsa yakınsamış sayılır</translation>
    </message>
    <message>
        <source>curvature asks for no shorter edge than this, in edges of a cube as large as a voxel; none: no limit</source>
        <translation>eğrilik, voksel büyüklüğündeki bir küpün kenarı cinsinden bundan kısa kenar istemez; none: sınır yok</translation>
    </message>
    <message>
        <source>cut every vessel that ends inside the volume this many radii before its tip, as end_1, end_2, ...; 0: off</source>
        <translation>hacim içinde biten her damarı ucundan bu kadar yarıçap önce keser; adlar end_1, end_2, ...; 0: kapalı</translation>
    </message>
    <message>
        <source>cut vessels that the border slices (by more than 30 degrees, or 1.3 times their section) straight across just inside, as across_1, across_2, ...</source>
        <translation>sınırın eğik kestiği damarları (30 dereceden çok ya da en kesitinin 1.3 katı) hemen içeride dik keser; adlar across_1, across_2, ...</translation>
    </message>
    <message>
        <source>do not start a surface expected to have more triangles than this; 0: no limit; auto: what fits this machine&apos;s memory and about half an hour</source>
        <translation>bundan çok üçgen beklenen yüzeye başlanmaz; 0: sınır yok; auto: bu makinenin belleğine ve yaklaşık yarım saate sığan kadar</translation>
    </message>
    <message>
        <source>each iteration smooths more</source>
        <translation>her yineleme daha çok yumuşatır</translation>
    </message>
    <message>
        <source>edge of a marching cubes cell, working voxels</source>
        <translation>marching cubes hücresinin kenarı, çalışma vokseli</translation>
    </message>
    <message>
        <source>end the evolution after this many iterations and take the front as it stands; none: it ends by itself</source>
        <translation>evrimi bu kadar yinelemeden sonra bitirir ve cepheyi olduğu gibi alır; none: kendiliğinden biter</translation>
    </message>
    <message>
        <source>faint vessels and noise get less</source>
        <translation>soluk damarlar ve gürültü daha düşük değer alır</translation>
    </message>
    <message>
        <source>faint vessels are left out</source>
        <translation>soluk damarlar dışarıda kalır</translation>
    </message>
    <message>
        <source>faint vessels get darker</source>
        <translation>soluk damarlar koyulaşır</translation>
    </message>
    <message>
        <source>faint vessels get no seeds of their own</source>
        <translation>soluk damarlar kendi tohumlarını almaz</translation>
    </message>
    <message>
        <source>fainter vessels get seeds, and so may what is none</source>
        <translation>daha soluk damarlar da tohum alır, damar olmayanlar da alabilir</translation>
    </message>
    <message>
        <source>fewer and larger triangles</source>
        <translation>daha az ve daha büyük üçgen</translation>
    </message>
    <message>
        <source>fewer and larger triangles, which follow the wall less closely</source>
        <translation>duvarı daha gevşek izleyen daha az ve daha büyük üçgen</translation>
    </message>
    <message>
        <source>fewer triangles on wide vessels</source>
        <translation>geniş damarlarda daha az üçgen</translation>
    </message>
    <message>
        <source>fewer triangles where the wall is most curved</source>
        <translation>duvarın en eğri olduğu yerlerde daha az üçgen</translation>
    </message>
    <message>
        <source>fewer triangles, and thin vessels get angular</source>
        <translation>daha az üçgen; ince damarlar köşelenir</translation>
    </message>
    <message>
        <source>find seeds by vesselness</source>
        <translation>tohumları damarsılığa göre bulur</translation>
    </message>
    <message>
        <source>flood: start from everything with v &gt;= b that is connected to a seed; seeds: grow from the seeds</source>
        <translation>flood: v &gt;= b olan ve bir tohuma bağlı her yerden başlar; seeds: tohumlardan büyür</translation>
    </message>
    <message>
        <source>gradient magnitude, intensities per working voxel, at which the contour has half its speed; auto: from the image&apos;s contrast and noise</source>
        <translation>konturun yarı hızda olduğu gradyan büyüklüğü, çalışma vokseli başına yoğunluk; auto: görüntünün kontrast ve gürültüsünden</translation>
    </message>
    <message>
        <source>half the edge of the cubes around the seeds that the first mean is taken of</source>
        <translation>ilk ortalamanın alındığı, tohumların çevresindeki küplerin yarı kenarı</translation>
    </message>
    <message>
        <source>half-width of the accepted intensity range around the region&apos;s mean, in standard deviations</source>
        <translation>bölge ortalamasının çevresinde kabul edilen yoğunluk aralığının yarı genişliği, standart sapma cinsinden</translation>
    </message>
    <message>
        <source>how far from the evolution&apos;s result the wall is looked for</source>
        <translation>duvarın, evrim sonucundan ne kadar uzağa dek arandığı</translation>
    </message>
    <message>
        <source>how far the lumen&apos;s brightness is averaged along the vessels: steps of 2/3 voxel^2</source>
        <translation>lümen parlaklığının damar boyunca ne kadar uzağa dek ortalandığı: 2/3 voksel^2 adımlar</translation>
    </message>
    <message>
        <source>how often the region is grown anew from its own mean and deviation</source>
        <translation>bölgenin kendi ortalama ve sapmasıyla kaç kez yeniden büyütüldüğü</translation>
    </message>
    <message>
        <source>how the vessels are segmented; label: the image is already a segmentation; the others are for comparison with the level set, from the same seeds</source>
        <translation>damarların nasıl bölütlendiği; label: görüntü zaten bir bölütlemedir; diğerleri, aynı tohumlardan, düzey kümesiyle karşılaştırma içindir</translation>
    </message>
    <message>
        <source>interpolant of phi whose zero set is the wall</source>
        <translation>sıfır kümesi duvar olan phi&apos;nin interpolantı</translation>
    </message>
    <message>
        <source>it takes fewer iterations, and flickers more about steep walls</source>
        <translation>daha az yineleme gerekir, dik duvarlarda daha çok titrer</translation>
    </message>
    <message>
        <source>iterations between two checks of convergence</source>
        <translation>iki yakınsama denetimi arasındaki yineleme sayısı</translation>
    </message>
    <message>
        <source>iterations of the curvature flow</source>
        <translation>eğrilik akışının yineleme sayısı</translation>
    </message>
    <message>
        <source>keep-wall: largest distance of a vertex from the wall, working voxels</source>
        <translation>keep-wall: bir düğümün duvardan en büyük uzaklığı, çalışma vokseli</translation>
    </message>
    <message>
        <source>keep-wall: smooths the triangulation, not the vessel; taubin: as in the thesis</source>
        <translation>keep-wall: damarı değil üçgenlemeyi yumuşatır; taubin: tezdeki gibi</translation>
    </message>
    <message>
        <source>larger surfaces are begun</source>
        <translation>daha büyük yüzeylere de başlanır</translation>
    </message>
    <message>
        <source>largest intensity of a vessel; auto: none (Otsu&apos;s threshold for dark vessels)</source>
        <translation>damarın en yüksek yoğunluğu; auto: yok (koyu damarlarda Otsu eşiği)</translation>
    </message>
    <message>
        <source>largest scale: about the radius of the thickest vessel; auto: 6 working voxels, or by scalesFromImage</source>
        <translation>en büyük ölçek: yaklaşık en kalın damarın yarıçapı; auto: 6 çalışma vokseli ya da scalesFromImage ile</translation>
    </message>
    <message>
        <source>largest sigma at which the negative branch acts; auto: 2 sigmaMin</source>
        <translation>negatif kolun etkidiği en büyük sigma; auto: 2 sigmaMin</translation>
    </message>
    <message>
        <source>largest step of the front per iteration; near 0.5 it flickers at steep walls, at 1/6 it comes to rest</source>
        <translation>cephenin yineleme başına en büyük adımı; 0.5 yakınında dik duvarlarda titrer, 1/6 değerinde durulur</translation>
    </message>
    <message>
        <source>least brightness of a vessel voxel, from the surroundings (0) to the lumen (1); the wall lies half-way, or here if this is higher</source>
        <translation>damar vokselinin en düşük parlaklığı, çevreden (0) lümene (1); duvar yarı yoldadır, bu değer daha yüksekse bu değerdedir</translation>
    </message>
    <message>
        <source>least intensity of a vessel; auto: Otsu&apos;s threshold (none for dark vessels)</source>
        <translation>damarın en düşük yoğunluğu; auto: Otsu eşiği (koyu damarlarda yok)</translation>
    </message>
    <message>
        <source>least number of edges around any vessel; none: only the curvature counts</source>
        <translation>her damarın çevresindeki en az kenar sayısı; none: yalnız eğrilik sayılır</translation>
    </message>
    <message>
        <source>less is segmented of images with much noise</source>
        <translation>çok gürültülü görüntülerde daha az bölütlenir</translation>
    </message>
    <message>
        <source>less is segmented of images with strong vessels</source>
        <translation>güçlü damarlı görüntülerde daha az bölütlenir</translation>
    </message>
    <message>
        <source>less is taken</source>
        <translation>daha azı alınır</translation>
    </message>
    <message>
        <source>less of bone and calcium is taken out</source>
        <translation>kemik ve kalsiyumun daha azı çıkarılır</translation>
    </message>
    <message>
        <source>less of the shrinking is made up for</source>
        <translation>büzülmenin daha azı giderilir</translation>
    </message>
    <message>
        <source>let an automatic sigmaMaxMm grow to half the radius of the thickest bright structure if that exceeds 6 working voxels, at most 15</source>
        <translation>otomatik sigmaMaxMm, en kalın parlak yapının yarıçapının yarısı 6 çalışma vokselini aşıyorsa o değere, en çok 15 voksele dek büyüyebilir</translation>
    </message>
    <message>
        <source>longer edges where the wall is curved</source>
        <translation>duvarın eğri olduğu yerlerde daha uzun kenarlar</translation>
    </message>
    <message>
        <source>longest wanted edge; none: no limit</source>
        <translation>istenen en uzun kenar; none: sınır yok</translation>
    </message>
    <message>
        <source>lower bound of b by eq. 3.20</source>
        <translation>denk. 3.20 ile bulunan b için alt sınır</translation>
    </message>
    <message>
        <source>lowest vesselness of an automatic seed (the best one is always kept); stops topPercent from taking noise where there are few vessels</source>
        <translation>otomatik bir tohumun en düşük damarsılığı (en iyisi hep kalır); damarın az olduğu yerde topPercent&apos;in gürültüyü almasını önler</translation>
    </message>
    <message>
        <source>make the wall as smooth as the vessel is, within what noise and contrast leave open</source>
        <translation>duvarı, gürültü ve kontrastın izin verdiği ölçüde, damar kadar düzgün yapar</translation>
    </message>
    <message>
        <source>map intensities through a sigmoid that keeps the range of the vessels</source>
        <translation>yoğunlukları, damarların aralığını koruyan bir sigmoidden geçirir</translation>
    </message>
    <message>
        <source>modified: eq. 3.22, negative beside vessels; frangi: eq. 3.15</source>
        <translation>modified: denk. 3.22, damarların yanında negatif; frangi: denk. 3.15</translation>
    </message>
    <message>
        <source>more is taken</source>
        <translation>daha çoğu alınır</translation>
    </message>
    <message>
        <source>more of each end is cut off</source>
        <translation>her ucun daha büyük bölümü kesilir</translation>
    </message>
    <message>
        <source>more of the dark tissue becomes one grey</source>
        <translation>koyu dokunun daha çoğu tek gri olur</translation>
    </message>
    <message>
        <source>most iterations of the evolution</source>
        <translation>evrimin en çok yineleme sayısı</translation>
    </message>
    <message>
        <source>neighbouring triangles are more alike, and there are more of them</source>
        <translation>komşu üçgenler birbirine daha çok benzer ve sayıları artar</translation>
    </message>
    <message>
        <source>new names of ports, which are given by their name in the report or by their position in mm LPS</source>
        <translation>açıklıkların yeni adları; açıklık, rapordaki adıyla ya da mm LPS konumuyla verilir</translation>
    </message>
    <message>
        <source>noise disturbs the contour less, and thin vessels are lost</source>
        <translation>gürültü konturu daha az bozar, ince damarlar kaybolur</translation>
    </message>
    <message>
        <source>noise disturbs the wall less, and neighbours run together</source>
        <translation>gürültü duvarı daha az bozar, komşular birleşir</translation>
    </message>
    <message>
        <source>noise disturbs the wall less, and short narrow places are filled</source>
        <translation>gürültü duvarı daha az bozar, kısa dar yerler dolar</translation>
    </message>
    <message>
        <source>noise goes, and then thin vessels</source>
        <translation>önce gürültü gider, sonra ince damarlar</translation>
    </message>
    <message>
        <source>noise goes, and thin vessels are lost</source>
        <translation>gürültü gider, ince damarlar da kaybolur</translation>
    </message>
    <message>
        <source>number of scales, evenly spaced in log(sigma); auto: by scaleRule</source>
        <translation>log(sigma) üzerinde eşit aralıklı ölçeklerin sayısı; auto: scaleRule ile</translation>
    </message>
    <message>
        <source>on: only rho sets the accuracy and 1/eta the gradation (eq. 4.4); off: 1/eta shortens the edges too</source>
        <translation>on: doğruluğu yalnız rho, geçişi 1/eta belirler (denk. 4.4); off: 1/eta kenarları da kısaltır</translation>
    </message>
    <message>
        <source>only stronger edges stop the contour</source>
        <translation>konturu yalnız daha güçlü kenarlar durdurur</translation>
    </message>
    <message>
        <source>only the parts that hold a seed</source>
        <translation>yalnız içinde tohum bulunan parçalar</translation>
    </message>
    <message>
        <source>parts with v &gt;= b and at least this many voxels count as vessels even without a seed</source>
        <translation>v &gt;= b olan ve en az bu kadar voksel içeren parçalar tohumsuz da damar sayılır</translation>
    </message>
    <message>
        <source>place the wall between the brightness of lumen and surroundings, after the evolution</source>
        <translation>evrimden sonra duvarı lümen ile çevrenin parlaklığı arasına yerleştirir</translation>
    </message>
    <message>
        <source>planes that cut vessels, in mm LPS, and the names of the openings; the part on the side of the normal is removed; without a normal the cut is straight across and removes the smaller part</source>
        <translation>damarları kesen düzlemler, mm LPS, ve açıklıkların adları; normalin gösterdiği taraf çıkarılır; normal verilmezse kesim diktir ve küçük parça çıkarılır</translation>
    </message>
    <message>
        <source>plates count less against vessels, so that flat vessels get less</source>
        <translation>levhalar damarlara karşı daha az sayılır, yassı damarlar daha düşük değer alır</translation>
    </message>
    <message>
        <source>radii between the scales are met better, and it takes longer</source>
        <translation>ölçekler arasındaki yarıçaplar daha iyi yakalanır, daha uzun sürer</translation>
    </message>
    <message>
        <source>radius of the starting spheres, working voxels</source>
        <translation>başlangıç kürelerinin yarıçapı, çalışma vokseli</translation>
    </message>
    <message>
        <source>raise darker voxels to this intensity; none: no lower bound</source>
        <translation>daha koyu vokselleri bu yoğunluğa yükseltir; none: alt sınır yok</translation>
    </message>
    <message>
        <source>ratio: ceil(log_1.5(max / min)) + 1; difference: eq. 5.1 in working voxels, at least 2</source>
        <translation>ratio: ceil(log_1.5(max / min)) + 1; difference: denk. 5.1, çalışma vokseliyle, en az 2</translation>
    </message>
    <message>
        <source>region of interest: two opposite corners x0,y0,z0,x1,y1,z1 in mm LPS</source>
        <translation>ilgi bölgesi: karşılıklı iki köşe x0,y0,z0,x1,y1,z1, mm LPS</translation>
    </message>
    <message>
        <source>resample to cubic voxels of the smallest spacing; auto: when spacing differs by more than 10 % and the voxels grow at most threefold</source>
        <translation>en küçük aralıkta kübik voksellere yeniden örnekler; auto: aralıklar yüzde 10&apos;dan çok farklıysa ve voksel sayısı en çok üç katına çıkıyorsa</translation>
    </message>
    <message>
        <source>robust: 99.9th percentile minus median; range: maximum minus minimum</source>
        <translation>robust: 99.9. yüzdelik eksi medyan; range: en büyük eksi en küçük</translation>
    </message>
    <message>
        <source>scale of the gradient that stops the contour</source>
        <translation>konturu durduran gradyanın ölçeği</translation>
    </message>
    <message>
        <source>scales the threshold b</source>
        <translation>b eşiğini ölçekler</translation>
    </message>
    <message>
        <source>seeds by hand, x,y,z,... in mm LPS, added to the automatic ones</source>
        <translation>elle konan tohumlar, x,y,z,..., mm LPS; otomatik olanlara eklenir</translation>
    </message>
    <message>
        <source>sensitivity to blobs (R_B)</source>
        <translation>yumrulara duyarlılık (R_B)</translation>
    </message>
    <message>
        <source>sensitivity to plates (R_A)</source>
        <translation>levhalara duyarlılık (R_A)</translation>
    </message>
    <message>
        <source>share of the voxels that become seeds, highest single-scale vesselness first</source>
        <translation>tohum olan voksellerin payı, tek ölçekli damarsılığı en yüksek olandan başlayarak</translation>
    </message>
    <message>
        <source>short pieces and blobs are left out, however thick they are</source>
        <translation>kısa parçalar ve yumrular, ne kadar kalın olursa olsun, dışarıda kalır</translation>
    </message>
    <message>
        <source>shortest wanted edge; none: no limit</source>
        <translation>istenen en kısa kenar; none: sınır yok</translation>
    </message>
    <message>
        <source>size of the window that the wall is fitted in, multiplied by the fourth root of (vessel radius x uncertainty of the wall), voxels</source>
        <translation>duvarın uydurulduğu pencerenin boyutu, (damar yarıçapı x duvar belirsizliği) değerinin dördüncü köküyle çarpılır, voksel</translation>
    </message>
    <message>
        <source>slow fronts are not taken for resting ones</source>
        <translation>yavaş cepheler durmuş sayılmaz</translation>
    </message>
    <message>
        <source>small parts are left out</source>
        <translation>küçük parçalar dışarıda kalır</translation>
    </message>
    <message>
        <source>small parts without a seed are left out</source>
        <translation>tohumsuz küçük parçalar dışarıda kalır</translation>
    </message>
    <message>
        <source>small pieces of the surface are left out</source>
        <translation>yüzeyin küçük parçaları dışarıda kalır</translation>
    </message>
    <message>
        <source>smallest scale: about the radius of the thinnest vessel; auto: 1 working voxel</source>
        <translation>en küçük ölçek: yaklaşık en ince damarın yarıçapı; auto: 1 çalışma vokseli</translation>
    </message>
    <message>
        <source>smooth along the edges of the image by curvature flow</source>
        <translation>görüntüyü eğrilik akışıyla kenarları boyunca yumuşatır</translation>
    </message>
    <message>
        <source>smoother, and with taubin the vessel&apos;s own detail goes too</source>
        <translation>daha düzgün; taubin ile damarın kendi ayrıntısı da gider</translation>
    </message>
    <message>
        <source>standard deviation of the image&apos;s point spread; auto: measured at the walls</source>
        <translation>görüntünün nokta yayılımının standart sapması; auto: duvarlarda ölçülür</translation>
    </message>
    <message>
        <source>strength of smoothing across the vessels, multiplied by the squared ratio of noise to contrast</source>
        <translation>damarların enine yumuşatma gücü, gürültü/kontrast oranının karesiyle çarpılır</translation>
    </message>
    <message>
        <source>strength of smoothing along the vessels, multiplied by the squared ratio of noise to contrast</source>
        <translation>damarların boyuna yumuşatma gücü, gürültü/kontrast oranının karesiyle çarpılır</translation>
    </message>
    <message>
        <source>strength of the curvature term</source>
        <translation>eğrilik teriminin gücü</translation>
    </message>
    <message>
        <source>structureness at which the measure saturates, intensities; auto: cFraction of the contrast</source>
        <translation>ölçünün doyduğu yapısallık, yoğunluk; auto: kontrastın cFraction katı</translation>
    </message>
    <message>
        <source>surface components that enclose less are left out</source>
        <translation>bundan az hacim çevreleyen yüzey bileşenleri dışarıda bırakılır</translation>
    </message>
    <message>
        <source>sweeps over the vertices, with taubin pairs of a lambda and a mu step; 0: nothing is smoothed</source>
        <translation>düğümler üzerinden geçiş sayısı, taubin ile bir lambda ve bir mu adımı çifti; 0: hiçbir şey yumuşatılmaz</translation>
    </message>
    <message>
        <source>the components that hold these points, x,y,z,... in mm LPS, are left out</source>
        <translation>bu noktaları, x,y,z,..., mm LPS, içeren bileşenler dışarıda bırakılır</translation>
    </message>
    <message>
        <source>the contour ends below this root mean square change of an iteration</source>
        <translation>kontur, bir yinelemedeki kare ortalama karekök değişim bunun altına inince biter</translation>
    </message>
    <message>
        <source>the contour ends here at the latest</source>
        <translation>kontur en geç burada biter</translation>
    </message>
    <message>
        <source>the contour ends sooner</source>
        <translation>kontur daha erken biter</translation>
    </message>
    <message>
        <source>the contour gets smoother, and stays out of thin vessels</source>
        <translation>kontur düzleşir ve ince damarlara girmez</translation>
    </message>
    <message>
        <source>the contour goes farther, and leaks sooner</source>
        <translation>kontur daha uzağa gider, daha erken sızar</translation>
    </message>
    <message>
        <source>the contour holds to edges more</source>
        <translation>kontur kenarlara daha çok tutunur</translation>
    </message>
    <message>
        <source>the contour stops more abruptly</source>
        <translation>kontur daha ani durur</translation>
    </message>
    <message>
        <source>the curvature is divided by it; 3 imitates the reference program</source>
        <translation>eğrilik buna bölünür; 3 referans programı taklit eder</translation>
    </message>
    <message>
        <source>the evolution ends sooner</source>
        <translation>evrim daha erken biter</translation>
    </message>
    <message>
        <source>the first mean takes in more of the surroundings</source>
        <translation>ilk ortalama çevreden daha çoğunu kapsar</translation>
    </message>
    <message>
        <source>the front follows the image more, and is less smooth</source>
        <translation>cephe görüntüyü daha çok izler, daha az düzgün olur</translation>
    </message>
    <message>
        <source>the front goes farther into thin vessels</source>
        <translation>cephe ince damarlarda daha uzağa gider</translation>
    </message>
    <message>
        <source>the front goes on for longer</source>
        <translation>cephe daha uzun süre ilerler</translation>
    </message>
    <message>
        <source>the front starts farther out, and may begin outside thin vessels</source>
        <translation>cephe daha dışarıdan başlar, ince damarların dışında başlayabilir</translation>
    </message>
    <message>
        <source>the interval fits the region more</source>
        <translation>aralık bölgeye daha çok uyar</translation>
    </message>
    <message>
        <source>the lumen&apos;s brightness is steadier, and follows changes along the vessel less</source>
        <translation>lümen parlaklığı daha kararlıdır, damar boyunca değişimleri daha az izler</translation>
    </message>
    <message>
        <source>the region grows, and leaks sooner</source>
        <translation>bölge büyür, daha erken sızar</translation>
    </message>
    <message>
        <source>the step from dark to bright gets gentler</source>
        <translation>koyudan parlağa geçiş yumuşar</translation>
    </message>
    <message>
        <source>the thinnest vessels are lost, and so is noise</source>
        <translation>en ince damarlar kaybolur, gürültü de</translation>
    </message>
    <message>
        <source>the wall gets smoother, and short bulges and dents are lost</source>
        <translation>duvar düzleşir, kısa çıkıntı ve çukurlar kaybolur</translation>
    </message>
    <message>
        <source>thicker vessels are found, neighbours may run together, and it takes longer</source>
        <translation>daha kalın damarlar bulunur, komşular birleşebilir, daha uzun sürer</translation>
    </message>
    <message>
        <source>thicker vessels are kept apart as well</source>
        <translation>daha kalın damarlar da ayrı tutulur</translation>
    </message>
    <message>
        <source>thin vessels are taken for thinner than they look</source>
        <translation>ince damarlar göründüklerinden daha ince sayılır</translation>
    </message>
    <message>
        <source>thin vessels get rounder, of more triangles</source>
        <translation>ince damarlar daha çok üçgenle yuvarlaklaşır</translation>
    </message>
    <message>
        <source>time step of the curvature flow, in voxels whatever their size; 0.0625 is stable</source>
        <translation>eğrilik akışının zaman adımı, boyutu ne olursa olsun voksel cinsinden; 0.0625 kararlıdır</translation>
    </message>
    <message>
        <source>upper bound of b by eq. 3.20</source>
        <translation>denk. 3.20 ile bulunan b için üst sınır</translation>
    </message>
    <message>
        <source>value of the voxels of a segmentation that are vessel</source>
        <translation>bir bölütlemede damar olan voksellerin değeri</translation>
    </message>
    <message>
        <source>vertices may leave the wall farther</source>
        <translation>düğümler duvardan daha çok uzaklaşabilir</translation>
    </message>
    <message>
        <source>vesselness at which the front stands still; auto: by bRule</source>
        <translation>cephenin durduğu damarsılık; auto: bRule ile</translation>
    </message>
    <message>
        <source>vessels are brighter or darker than their surroundings</source>
        <translation>damarlar çevrelerinden daha parlak ya da daha koyudur</translation>
    </message>
    <message>
        <source>vessels get thinner, and narrow ones part</source>
        <translation>damarlar incelir, dar olanlar kopar</translation>
    </message>
    <message>
        <source>walls farther out are found, and it takes longer</source>
        <translation>daha dışarıdaki duvarlar bulunur, daha uzun sürer</translation>
    </message>
    <message>
        <source>weight of the contour&apos;s outward speed</source>
        <translation>konturun dışa doğru hızının ağırlığı</translation>
    </message>
    <message>
        <source>weight of the growing step</source>
        <translation>büyütme adımının ağırlığı</translation>
    </message>
    <message>
        <source>weight of the shrinking step</source>
        <translation>büzme adımının ağırlığı</translation>
    </message>
    <message>
        <source>weight of the term that draws the contour to edges</source>
        <translation>konturu kenarlara çeken terimin ağırlığı</translation>
    </message>
    <message>
        <source>weight of the term that smooths the contour</source>
        <translation>konturu yumuşatan terimin ağırlığı</translation>
    </message>
    <message>
        <source>weight of the vesselness term against the curvature term</source>
        <translation>damarsılık teriminin eğrilik terimine göre ağırlığı</translation>
    </message>
    <message>
        <source>where a vessel leaves the volume: a flat cap or an open rim</source>
        <translation>bir damarın hacimden çıktığı yer: düz bir kapak ya da açık bir ağız</translation>
    </message>
    <message>
        <source>which components go into the surface; seeded: those that hold a seed given by hand</source>
        <translation>yüzeye hangi bileşenlerin girdiği; seeded: elle verilmiş bir tohum içerenler</translation>
    </message>
    <message>
        <source>which voxels of a mask or label are joined: those that share a face (6 neighbours), an edge too (18) or a corner too (26)</source>
        <translation>bir maskenin ya da etiketin hangi voksellerinin bağlı sayıldığı: yüzü (6 komşu), kenarı da (18) ya da köşesi de (26) ortak olanlar</translation>
    </message>
    <message>
        <source>width of a Gaussian before the threshold; 0: none</source>
        <translation>eşiklemeden önceki Gauss süzgecinin genişliği; 0: yok</translation>
    </message>
    <message>
        <source>width of that rim, in voxels of the input</source>
        <translation>bu çeperin genişliği, girdi vokseli</translation>
    </message>
    <message>
        <source>width of the sigmoid of the gradient magnitude, negative; auto: from the image&apos;s contrast and noise</source>
        <translation>gradyan büyüklüğü sigmoidinin genişliği, negatif; auto: görüntünün kontrast ve gürültüsünden</translation>
    </message>
    <message>
        <source>width of the sigmoid, as the viewer&apos;s window; auto: 1st to 99.8th percentile</source>
        <translation>sigmoidin genişliği, görüntüleyicinin penceresi gibi; auto: 1. – 99.8. yüzdelik</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Düzeltmeler</translation>
    </message>
    <message>
        <source>corrections of the segmentation by hand, made in their order after the evolution</source>
        <translation>segmentasyonun elle yapılan düzeltmeleri, evrimden sonra sırayla uygulanır</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>Any CT angiography in HU: bone and what is darker than water are put aside.</source>
        <translation>HU cinsinden her BT anjiyografi: kemik ve sudan koyu olan her şey kenara bırakılır.</translation>
    </message>
    <message>
        <source>CT angiography of the head in HU: as ct, vessels up to 6 mm wide; separate parts shorter than 10 mm are left out.</source>
        <translation>HU cinsinden baş BT anjiyografisi: ct gibi, 6 mm genişliğe kadar damarlar; 10 mm&apos;den kısa ayrı parçalar dışarıda bırakılır.</translation>
    </message>
    <message>
        <source>Contrast-enhanced MR angiography of pelvis and legs: vessels up to 12 mm wide; separate parts shorter than 30 mm are left out.</source>
        <translation>Pelvis ve bacakların kontrastlı MR anjiyografisi: 12 mm genişliğe kadar damarlar; 30 mm&apos;den kısa ayrı parçalar dışarıda bırakılır.</translation>
    </message>
    <message>
        <source>Contrast-enhanced MR angiography of the abdomen: vessels up to 25 mm wide; separate parts shorter than 30 mm are left out.</source>
        <translation>Karnın kontrastlı MR anjiyografisi: 25 mm genişliğe kadar damarlar; 30 mm&apos;den kısa ayrı parçalar dışarıda bırakılır.</translation>
    </message>
    <message>
        <source>The default: any MR angiography in which vessels are the brightest thing.</source>
        <translation>Varsayılan: damarların en parlak yapı olduğu her MR anjiyografi.</translation>
    </message>
    <message>
        <source>The method as printed in the thesis, for comparison: slower and less accurate.</source>
        <translation>Tezde basıldığı haliyle yöntem, karşılaştırma için: daha yavaş ve daha az doğru.</translation>
    </message>
    <message>
        <source>Time-of-flight MR angiography of the brain: vessels up to 6 mm wide; separate parts shorter than 10 mm are left out.</source>
        <translation>Beynin time-of-flight MR anjiyografisi: 6 mm genişliğe kadar damarlar; 10 mm&apos;den kısa ayrı parçalar dışarıda bırakılır.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Save case</source>
        <translation>Vakayı kaydet</translation>
    </message>
    <message>
        <source>There is a case %1 already. Replace it?</source>
        <translation>%1 adlı bir vaka zaten var. Yerine yazılsın mı?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Kaydedilmemiş değişiklikler</translation>
    </message>
    <message>
        <source>The case %1 has changes that are not saved.</source>
        <translation>%1 vakasında kaydedilmemiş değişiklikler var.</translation>
    </message>
    <message>
        <source>Restore edits</source>
        <translation>Düzenlemeleri geri yükle</translation>
    </message>
    <message>
        <source>Angiomesh ended before these changes were saved:
%1</source>
        <translation>Angiomesh bu değişiklikler kaydedilmeden sona erdi:
%1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Geri yükle</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>At</translation>
    </message>
    <message>
        <source>Ask again later</source>
        <translation>Sonra yeniden sor</translation>
    </message>
    <message>
        <source>The volume of this case is not where it was, nor beside the case:
%1</source>
        <translation>Bu vakanın hacmi eski yerinde de vakanın yanında da değil:
%1</translation>
    </message>
    <message>
        <source>The case cannot be opened with this volume: %1.</source>
        <translation>Vaka bu hacimle açılamıyor: %1.</translation>
    </message>
    <message>
        <source>Where is the volume?</source>
        <translation>Hacim nerede?</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Dosya seç…</translation>
    </message>
    <message>
        <source>Choose a DICOM folder…</source>
        <translation>DICOM klasörü seç…</translation>
    </message>
    <message>
        <source>Open it with the case&apos;s parameters only</source>
        <translation>Yalnız vakanın parametreleriyle aç</translation>
    </message>
    <message>
        <source>Seeds, the region of interest and the parts left out are places in the other volume and are not taken over.</source>
        <translation>Tohumlar, ilgi bölgesi ve dışarıda bırakılan parçalar öteki hacimdeki yerlerdir ve aktarılmaz.</translation>
    </message>
    <message>
        <source>Save case as</source>
        <translation>Vakayı farklı kaydet</translation>
    </message>
    <message>
        <source>Cases (*.angiomesh)</source>
        <translation>Vakalar (*.angiomesh)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Hacim aç</translation>
    </message>
    <message>
        <source>Volumes (*%1);;Cases (case.json);;All files (*)</source>
        <translation>Hacimler (*%1);;Vakalar (case.json);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>DICOM klasörü aç</translation>
    </message>
    <message>
        <source>Import ports</source>
        <translation>Açıklıkları içe aktar</translation>
    </message>
    <message>
        <source>Ports (*.json);;All files (*)</source>
        <translation>Açıklıklar (*.json);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>About Angiomesh</source>
        <translation>Angiomesh hakkında</translation>
    </message>
    <message>
        <source>Angiomesh %1

From an angiogram to a vessel surface that a flow solver accepts.
Not a medical device: research use only.

BSD-3-Clause.</source>
        <translation>Angiomesh %1

Anjiyogramdan akış çözücünün kabul ettiği damar yüzeyine.
Tıbbi cihaz değildir: yalnız araştırma amaçlıdır.

BSD-3-Clause.</translation>
    </message>
    <message>
        <source>Uneven slices</source>
        <translation>Eşitsiz kesit aralığı</translation>
    </message>
    <message>
        <source>The slices of the series are not at even distances.</source>
        <translation>Serinin kesitleri eşit aralıklı değil.</translation>
    </message>
    <message>
        <source>Resample them</source>
        <translation>Yeniden örnekle</translation>
    </message>
    <message>
        <source>measure a distance</source>
        <translation>mesafe ölçümü</translation>
    </message>
    <message>
        <source>measure a section</source>
        <translation>en kesit ölçümü</translation>
    </message>
    <message>
        <source>measure the diameter along a branch</source>
        <translation>dal boyunca çap ölçümü</translation>
    </message>
    <message>
        <source>measure a stenosis</source>
        <translation>stenoz ölçümü</translation>
    </message>
    <message>
        <source>Ø min %1, max %2, of the area %3 mm; area %4 mm²</source>
        <translation>Ø min. %1, maks. %2, alandan %3 mm; alan %4 mm²</translation>
    </message>
    <message>
        <source>Ø %1 to %2, mean %3 mm, along %4 mm</source>
        <translation>Ø %1 – %2, ortalama %3 mm, %4 mm boyunca</translation>
    </message>
    <message>
        <source>D</source>
        <comment>a least diameter</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>A</source>
        <comment>an area</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>NASCET</source>
        <translation>NASCET</translation>
    </message>
    <message>
        <source>WASID</source>
        <translation>WASID</translation>
    </message>
    <message>
        <source>By area</source>
        <translation>Alana göre</translation>
    </message>
    <message>
        <source>D, A: least diameter and area of the narrowest section between the two places. Proximal is the place that was clicked first, distal the second.</source>
        <translation>D, A: iki yer arasındaki en dar en kesitin en küçük çapı ve alanı. Proksimal ilk tıklanan, distal ikinci tıklanan yerdir.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Mesafe</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>En kesit</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Dal</translation>
    </message>
    <message>
        <source>Stenosis</source>
        <translation>Stenoz</translation>
    </message>
    <message>
        <source>Click the two ends of a distance.</source>
        <translation>Mesafenin iki ucunu tıklayın.</translation>
    </message>
    <message>
        <source>Click the other end.</source>
        <translation>Öteki ucu tıklayın.</translation>
    </message>
    <message>
        <source>Click a vessel where it is to be cut across.</source>
        <translation>Damarı, kesitinin alınacağı yerde tıklayın.</translation>
    </message>
    <message>
        <source>Click a branch to see its diameter from end to end.</source>
        <translation>Bir ucundan ötekine çapını görmek için bir dalı tıklayın.</translation>
    </message>
    <message>
        <source>Click the vessel where it is normal, first on the side that the blood comes from, then behind the narrowing.</source>
        <translation>Damarı normal olduğu yerde tıklayın: önce kanın geldiği tarafta, sonra darlığın arkasında.</translation>
    </message>
    <message>
        <source>Click the vessel where it is normal again, behind the narrowing.</source>
        <translation>Damarı, darlığın arkasında yeniden normal olduğu yerde tıklayın.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>NASCET %1, WASID %2, by area %3</source>
        <translation>NASCET %1, WASID %2, alana göre %3</translation>
    </message>
    <message>
        <source>In a straight line from one place to the other.</source>
        <translation>Bir yerden ötekine düz çizgi boyunca.</translation>
    </message>
    <message>
        <source>Across the vessel&apos;s axis. Min: the least distance of two parallel lines that hold the outline between them. Max: the greatest distance of two of its points. Of the area: the circle that is as large, √(4 A / π).</source>
        <translation>Damarın eksenine dik. Min.: dış hattı aralarında tutan iki paralel doğrunun en küçük uzaklığı. Maks.: dış hattın iki noktasının en büyük uzaklığı. Alandan: eş alanlı çember, √(4 A / π).</translation>
    </message>
    <message>
        <source>Diameter of the circle as large as the section across the centre line, from end to end of the branch; thin: least diameter. Left out where vessels part.</source>
        <translation>Dalın bir ucundan ötekine, merkez hattına dik en kesitle eş alanlı çemberin çapı; ince çizgi: en küçük çap. Damarların ayrıldığı yerler atlanır.</translation>
    </message>
    <message>
        <source>%1, out of date</source>
        <translation>%1, güncel değil</translation>
    </message>
    <message>
        <source>Evolving, back at iteration %1</source>
        <translation>Evrim sürüyor, gösterilen yineleme %1</translation>
    </message>
    <message>
        <source>Result %1, the front after iteration %2</source>
        <translation>Sonuç %1, %2. yinelemeden sonraki cephe</translation>
    </message>
    <message>
        <source>Evolving, iteration %1</source>
        <translation>Evrim sürüyor, yineleme %1</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Sonuç %1</translation>
    </message>
    <message>
        <source>Source (no %1 yet)</source>
        <translation>Kaynak (henüz %1 yok)</translation>
    </message>
    <message>
        <source>No %1 yet to lay over it</source>
        <translation>Üstüne konacak %1 henüz yok</translation>
    </message>
    <message>
        <source>%1 over it</source>
        <translation>Üstünde: %1</translation>
    </message>
    <message>
        <source>%1, no mesh yet</source>
        <translation>%1, henüz ağ yok</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kaynak</translation>
    </message>
    <message>
        <source>Preprocessed</source>
        <translation>Ön işlenmiş</translation>
    </message>
    <message>
        <source>Vesselness</source>
        <translation>Damarsılık</translation>
    </message>
    <message>
        <source>Speed p</source>
        <translation>Hız p</translation>
    </message>
    <message>
        <source>exported (smoothed)</source>
        <translation>aktarılan (yumuşatılmış)</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>yumuşatılmamış</translation>
    </message>
    <message>
        <source>marching cubes</source>
        <translation>marching cubes</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels of %4 × %5 × %6 mm</source>
        <translation>%1 × %2 × %3 voksel, her biri %4 × %5 × %6 mm</translation>
    </message>
    <message>
        <source>a few seconds</source>
        <translation>birkaç saniye</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>yaklaşık %1 sn</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>yaklaşık %1 dk</translation>
    </message>
    <message>
        <source>Evolve</source>
        <translation>Evrim</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Yükleme</translation>
    </message>
    <message>
        <source>Preprocess</source>
        <translation>Ön işleme</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kalite</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Tohumlar</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Yumuşatma</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Yüzey</translation>
    </message>
    <message>
        <source>Compare with a mesh</source>
        <translation>Bir ağla karşılaştır</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Ağlar (%1);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Mesh from a file</source>
        <translation>Dosyadan ağ</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>dosyadan</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Düzelt</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Ön ayarı içe aktar</translation>
    </message>
    <message>
        <source>There is a preset %1 already. Replace it?</source>
        <translation>%1 adlı bir ön ayar zaten var. Değiştirilsin mi?</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Ön ayarı kaldır</translation>
    </message>
    <message>
        <source>Remove the preset %1 for good? The parameters in use stay.</source>
        <translation>%1 ön ayarı kalıcı olarak kaldırılsın mı? Kullanılan parametreler kalır.</translation>
    </message>
    <message>
        <source>Presets, recipes and parameters (*.json);;All files (*)</source>
        <translation>Ön ayarlar, reçeteler ve parametreler (*.json);;Tüm dosyalar (*)</translation>
    </message>
    <message>
        <source>Revie&amp;w</source>
        <translation>İ&amp;nceleme</translation>
    </message>
    <message>
        <source>Open the review</source>
        <translation>İncelemeyi aç</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Next doubtful place</source>
        <translation>Sonraki şüpheli yer</translation>
    </message>
    <message>
        <source>Previous doubtful place</source>
        <translation>Önceki şüpheli yer</translation>
    </message>
    <message>
        <source>Add a remark at the crosshair</source>
        <translation>Artı imlece not ekle</translation>
    </message>
    <message>
        <source>Ctrl+Alt+M</source>
        <translation>Ctrl+Alt+M</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>Ç&amp;alıştır</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Çalıştır</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Duraklat</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Adım</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Bitir</translation>
    </message>
    <message>
        <source>Sensitivity to the parameters</source>
        <translation>Parametrelere duyarlılık</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>all</source>
        <translation>tümü</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>en çok %1</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>altı: %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>üstü: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>en az %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: passes</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: geçiyor</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: fails, %2 of %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: geçmiyor, tutmayan %2 / %3</translation>
    </message>
</context>
<context>
    <name>QualityGate</name>
    <message>
        <source>A triangle without area has no normal.</source>
        <translation>Alansız bir üçgenin normali yoktur.</translation>
    </message>
    <message>
        <source>Close the ends: surface.border cap.</source>
        <translation>Uçları kapatın: surface.border cap.</translation>
    </message>
    <message>
        <source>Flat triangles make flat cells beside the wall, where the solution is inexact.</source>
        <translation>Yassı üçgenler duvar yanında yassı hücreler oluşturur, orada çözüm yeterince doğru olmaz.</translation>
    </message>
    <message>
        <source>Inside and outside cannot be told apart.</source>
        <translation>İç ile dış birbirinden ayrılamıyor.</translation>
    </message>
    <message>
        <source>Leave parts out: untick them, or raise segmentation.minVolumeMm3.</source>
        <translation>Parçaları dışarıda bırakın: işaretlerini kaldırın ya da segmentation.minVolumeMm3 değerini artırın.</translation>
    </message>
    <message>
        <source>Make surface.rho smaller: edges get shorter where the wall bends.</source>
        <translation>surface.rho değerini küçültün: duvarın büküldüğü yerde kenarlar kısalır.</translation>
    </message>
    <message>
        <source>Mesh the segmentation with surface.method advancing-front.</source>
        <translation>Bölütlemeyi surface.method advancing-front ile ağlayın.</translation>
    </message>
    <message>
        <source>Parts that do not hang together fall apart.</source>
        <translation>Birbirine bağlı olmayan parçalar dağılır.</translation>
    </message>
    <message>
        <source>The inside leaks through open rims.</source>
        <translation>İç hacim açık ağızlardan sızar.</translation>
    </message>
    <message>
        <source>There is no surface.</source>
        <translation>Yüzey yok.</translation>
    </message>
    <message>
        <source>Volume meshers refuse a surface that forks at an edge.</source>
        <translation>Hacim ağlayıcılar bir kenarda çatallanan yüzeyi kabul etmez.</translation>
    </message>
    <message>
        <source>Volume meshers refuse a surface that touches itself at a vertex.</source>
        <translation>Hacim ağlayıcılar bir düğümde kendine değen yüzeyi kabul etmez.</translation>
    </message>
    <message>
        <source>What is thinner than the strand of a usual nozzle (0.4 mm wide) breaks or is left out.</source>
        <translation>Yaygın bir nozülün bıraktığı iplikten (0.4 mm genişlik) ince olan kırılır ya da basılmaz.</translation>
    </message>
    <message>
        <source>Where the surface cuts itself, inside and outside are not defined.</source>
        <translation>Yüzeyin kendini kestiği yerde iç ve dış tanımsızdır.</translation>
    </message>
    <message>
        <source>as closed, all angles from 30 to 110 degrees, all radius ratios at least 0.6</source>
        <translation>closed gibi; tüm açılar 30 ile 110 derece arasında, tüm yarıçap oranları en az 0.6</translation>
    </message>
    <message>
        <source>as closed, and no angle below 15 degrees</source>
        <translation>closed gibi; 15 derecenin altında açı yok</translation>
    </message>
    <message>
        <source>as closed, in one part, and thinner than 0.5 mm at no more than 1 % of the triangles</source>
        <translation>closed gibi; tek parça, üçgenlerin en çok yüzde 1 kadarında 0.5 mm&apos;den ince</translation>
    </message>
    <message>
        <source>as manifold, and no boundary edge</source>
        <translation>manifold gibi; sınır kenarı yok</translation>
    </message>
    <message>
        <source>oriented, no non-manifold spot, degenerate triangle or self-intersection</source>
        <translation>yönlü; manifold olmayan yer, dejenere üçgen, kendiyle kesişme yok</translation>
    </message>
</context>
<context>
    <name>QualityMeasure</name>
    <message>
        <source>Verified parts</source>
        <translation>Doğrulanan parça</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>evet</translation>
    </message>
    <message>
        <source>no</source>
        <translation>hayır</translation>
    </message>
    <message>
        <source>1st percentile</source>
        <translation>1. yüzdelik</translation>
    </message>
    <message>
        <source>1st percentile of the smallest angle of each triangle</source>
        <translation>her üçgenin en küçük açısının 1. yüzdeliği</translation>
    </message>
    <message>
        <source>2 * inradius / circumradius; 1 is equilateral</source>
        <translation>2 * iç yarıçap / çevrel yarıçap; eşkenarda 1</translation>
    </message>
    <message>
        <source>99th percentile of the largest angle of each triangle</source>
        <translation>her üçgenin en büyük açısının 99. yüzdeliği</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Alan</translation>
    </message>
    <message>
        <source>Aspect ratio, mean</source>
        <translation>En-boy oranı, ort.</translation>
    </message>
    <message>
        <source>Aspect ratio, most</source>
        <translation>En-boy oranı, maks.</translation>
    </message>
    <message>
        <source>Below 20 deg</source>
        <translation>20 derece altı</translation>
    </message>
    <message>
        <source>Below 30 deg</source>
        <translation>30 derece altı</translation>
    </message>
    <message>
        <source>Boundary edges</source>
        <translation>Sınır kenarları</translation>
    </message>
    <message>
        <source>Boundary loops</source>
        <translation>Sınır döngüleri</translation>
    </message>
    <message>
        <source>Centroid off, 99 %</source>
        <translation>Merkez sapması, 99 %</translation>
    </message>
    <message>
        <source>Centroid off, mean</source>
        <translation>Merkez sapması, ort.</translation>
    </message>
    <message>
        <source>Centroid off, most</source>
        <translation>Merkez sapması, maks.</translation>
    </message>
    <message>
        <source>Centroid x curv., 99 %</source>
        <translation>Merkez x eğr., 99 %</translation>
    </message>
    <message>
        <source>Centroid x curv., mean</source>
        <translation>Merkez x eğr., ort.</translation>
    </message>
    <message>
        <source>Centroid x curv., most</source>
        <translation>Merkez x eğr., maks.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Kapalı</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Bileşenler</translation>
    </message>
    <message>
        <source>Corner triangles</source>
        <translation>Köşe üçgenleri</translation>
    </message>
    <message>
        <source>Degenerate triangles</source>
        <translation>Dejenere üçgenler</translation>
    </message>
    <message>
        <source>Edge, mean</source>
        <translation>Kenar, ort.</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Euler sayısı</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Cepheden</translation>
    </message>
    <message>
        <source>Gaps below an edge</source>
        <translation>Kenardan dar boşluk</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Cins (genus)</translation>
    </message>
    <message>
        <source>Gradation, 99 %</source>
        <translation>Boyut geçişi, 99 %</translation>
    </message>
    <message>
        <source>Gradation, most</source>
        <translation>Boyut geçişi, maks.</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>En büyük açı</translation>
    </message>
    <message>
        <source>Least angle</source>
        <translation>En küçük açı</translation>
    </message>
    <message>
        <source>Least radius ratio</source>
        <translation>En az yarıçap oranı</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>En uzun kenar</translation>
    </message>
    <message>
        <source>Max angle, 99 %</source>
        <translation>Maks. açı, 99 %</translation>
    </message>
    <message>
        <source>Max angle, corners</source>
        <translation>Maks. açı, köşeler</translation>
    </message>
    <message>
        <source>Max angle, others</source>
        <translation>Maks. açı, diğer</translation>
    </message>
    <message>
        <source>Min angle, 1 %</source>
        <translation>Min. açı, 1 %</translation>
    </message>
    <message>
        <source>Min angle, corners</source>
        <translation>Min. açı, köşeler</translation>
    </message>
    <message>
        <source>Min angle, mean</source>
        <translation>Min. açı, ort.</translation>
    </message>
    <message>
        <source>Min angle, others</source>
        <translation>Min. açı, diğer</translation>
    </message>
    <message>
        <source>Min ratio, corners</source>
        <translation>Min. oran, köşeler</translation>
    </message>
    <message>
        <source>Min ratio, others</source>
        <translation>Min. oran, diğer</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Manifold olmayan kenar</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>Manifold olmayan düğüm</translation>
    </message>
    <message>
        <source>Oriented</source>
        <translation>Yönlü</translation>
    </message>
    <message>
        <source>Radius ratio, 1 %</source>
        <translation>Yarıçap oranı, 1 %</translation>
    </message>
    <message>
        <source>Radius ratio, mean</source>
        <translation>Yarıçap oranı, ort.</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Pürüzlülük</translation>
    </message>
    <message>
        <source>Roughness, 95 %</source>
        <translation>Pürüzlülük, 95 %</translation>
    </message>
    <message>
        <source>Roughness, angle</source>
        <translation>Pürüzlülük, açı</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>Kendiyle kesişmeler</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>En kısa kenar</translation>
    </message>
    <message>
        <source>Skewness, mean</source>
        <translation>Çarpıklık, ort.</translation>
    </message>
    <message>
        <source>Skewness, most</source>
        <translation>Çarpıklık, maks.</translation>
    </message>
    <message>
        <source>Thickness, 1 %</source>
        <translation>Kalınlık, 1 %</translation>
    </message>
    <message>
        <source>Thinnest gap</source>
        <translation>En dar boşluk</translation>
    </message>
    <message>
        <source>Thinnest part</source>
        <translation>En ince yer</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Üçgenler</translation>
    </message>
    <message>
        <source>Valence 5 to 7</source>
        <translation>Valans 5 – 7</translation>
    </message>
    <message>
        <source>Valence, least</source>
        <translation>Valans, en az</translation>
    </message>
    <message>
        <source>Valence, most</source>
        <translation>Valans, en çok</translation>
    </message>
    <message>
        <source>Vertex off, 99 %</source>
        <translation>Düğüm sapması, 99 %</translation>
    </message>
    <message>
        <source>Vertex off, mean</source>
        <translation>Düğüm sapması, ort.</translation>
    </message>
    <message>
        <source>Vertex off, most</source>
        <translation>Düğüm sapması, maks.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Düğümler</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Hacim</translation>
    </message>
    <message>
        <source>by the divergence theorem, positive for outward faces; absent if not closed and oriented</source>
        <translation>diverjans teoremiyle, dışa bakan yüzlerde pozitif; kapalı ve yönlü değilse yok</translation>
    </message>
    <message>
        <source>distance from the zero set of the interpolant that was meshed, caps apart</source>
        <translation>ağlanan interpolantın sıfır kümesinden uzaklık, kapaklar hariç</translation>
    </message>
    <message>
        <source>edge-connected sets of triangles</source>
        <translation>kenarlarla bağlı üçgen kümeleri</translation>
    </message>
    <message>
        <source>edges of more than two triangles</source>
        <translation>ikiden çok üçgenin kenarları</translation>
    </message>
    <message>
        <source>equiangular skewness, as in Fluent: max((largest angle - 60) / 120, (60 - smallest) / 60); 0 is equilateral, 1 has no area</source>
        <translation>eşit açılı çarpıklık, Fluent&apos;teki gibi: max((en büyük açı - 60) / 120, (60 - en küçük) / 60); 0 eşkenar, 1 alansız</translation>
    </message>
    <message>
        <source>exactly collinear or repeated corners</source>
        <translation>tam olarak doğrusal ya da yinelenen köşeler</translation>
    </message>
    <message>
        <source>from the centroid of a triangle straight inwards to the other side, caps apart; beside a sharp edge it is short</source>
        <translation>üçgenin ağırlık merkezinden dümdüz içeri, öteki tarafa, kapaklar hariç; keskin bir kenarın yanında kısadır</translation>
    </message>
    <message>
        <source>from the centroid of a triangle straight outwards to the wall again, in mean edges of the triangle; absent if none is below 3</source>
        <translation>üçgenin ağırlık merkezinden dümdüz dışarı, yeniden duvara kadar, üçgenin ortalama kenarı cinsinden; 3&apos;ün altında yoksa verilmez</translation>
    </message>
    <message>
        <source>in all others</source>
        <translation>geri kalanların hepsinde</translation>
    </message>
    <message>
        <source>in such triangles</source>
        <translation>böyle üçgenlerde</translation>
    </message>
    <message>
        <source>its 95th percentile; branchings and tips raise it</source>
        <translation>bunun 95. yüzdeliği; dallanmalar ve uçlar artırır</translation>
    </message>
    <message>
        <source>longest edge / (inradius * 12^0.5); 1 is equilateral</source>
        <translation>en uzun kenar / (iç yarıçap * 12^0.5); eşkenarda 1</translation>
    </message>
    <message>
        <source>mean edge of a triangle over that of a neighbour, the larger over the smaller one; 1 is even</source>
        <translation>üçgenin ortalama kenarının komşununkine oranı, büyük bölü küçük; 1 eşit demektir</translation>
    </message>
    <message>
        <source>median of the angle between neighbouring triangles that neither their size nor the curvature of the wall explains</source>
        <translation>komşu üçgenler arasındaki açının, ne boyutlarının ne de duvarın eğriliğinin açıkladığı kısmının medyanı</translation>
    </message>
    <message>
        <source>median of the vertices&apos; root mean square distance from a smooth fit around them, see report.md</source>
        <translation>düğümlerin, çevrelerine uydurulan düzgün yüzeye kare ortalama karekök uzaklığının medyanı, bkz. report.md</translation>
    </message>
    <message>
        <source>neighbours agree on the outside</source>
        <translation>komşular hangi tarafın dış olduğunda uyuşuyor</translation>
    </message>
    <message>
        <source>no boundary edge</source>
        <translation>sınır kenarı yok</translation>
    </message>
    <message>
        <source>of open rims</source>
        <translation>açık ağızların</translation>
    </message>
    <message>
        <source>of the triangles, by smallest angle</source>
        <translation>üçgenlerin payı, en küçük açıya göre</translation>
    </message>
    <message>
        <source>of the triangles: tetrahedra between the walls would be flat</source>
        <translation>üçgenlerin payı: duvarlar arasındaki dörtyüzlüler yassı olurdu</translation>
    </message>
    <message>
        <source>of the vertices, open rims apart</source>
        <translation>düğümlerin payı, açık ağızlar hariç</translation>
    </message>
    <message>
        <source>open rims</source>
        <translation>açık ağızlar</translation>
    </message>
    <message>
        <source>pairs of triangles that meet outside shared corners and edges, by exact predicates</source>
        <translation>ortak köşe ve kenarlar dışında buluşan üçgen çiftleri, kesin yüklemlerle</translation>
    </message>
    <message>
        <source>points that triangles use</source>
        <translation>üçgenlerin kullandığı noktalar</translation>
    </message>
    <message>
        <source>share of the triangles that the advancing front made; absent for other methods</source>
        <translation>ilerleyen cephenin ürettiği üçgenlerin payı; diğer yöntemlerde yok</translation>
    </message>
    <message>
        <source>sum of 2 - 2 genus - rims</source>
        <translation>2 - 2 cins - ağız toplamı</translation>
    </message>
    <message>
        <source>sum over the components</source>
        <translation>bileşenlerin toplamı</translation>
    </message>
    <message>
        <source>the same of the centroids of the triangles</source>
        <translation>aynısı, üçgenlerin ağırlık merkezleri için</translation>
    </message>
    <message>
        <source>the smallest of all angles; gates leave out corners of the outline</source>
        <translation>tüm açıların en küçüğü; koşullar dış hattın köşelerini saymaz</translation>
    </message>
    <message>
        <source>those with two sides on the borders of two other patches, whose angles no mesher chooses; absent if there are none</source>
        <translation>iki kenarı iki başka yamanın sınırında olanlar, açılarını hiçbir ağlayıcı seçemez; böylesi yoksa verilmez</translation>
    </message>
    <message>
        <source>times the largest principal curvature there, a pure number: about 0.008 for the triangles of an inscribed surface with 20 edges around a tube</source>
        <translation>oradaki en büyük asal eğrilikle çarpılır, boyutsuz sayı: bir tüpün çevresinde 20 kenarlı iç çizilmiş yüzeyin üçgenleri için yaklaşık 0.008</translation>
    </message>
    <message>
        <source>triangles at a vertex, open rims apart; 6 in an even mesh</source>
        <translation>bir düğümdeki üçgen sayısı, açık ağızlar hariç; düzgün bir ağda 6</translation>
    </message>
    <message>
        <source>vertices whose triangles do not form a single fan</source>
        <translation>üçgenleri tek bir yelpaze oluşturmayan düğümler</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Parameter</source>
        <translation>Parametre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Değer</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Anahtar</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Yok.</translation>
    </message>
    <message>
        <source>Report on a vessel mesh</source>
        <translation>Damar ağı raporu</translation>
    </message>
    <message>
        <source>Scan: %1</source>
        <translation>Çekim: %1</translation>
    </message>
    <message>
        <source>Angiomesh %1. Not a medical device: research use only.</source>
        <translation>Angiomesh %1. Tıbbi cihaz değildir: yalnız araştırma amaçlıdır.</translation>
    </message>
    <message>
        <source>No patient, date or file is named here; remarks and names of measurements and openings stand as they were typed.</source>
        <translation>Burada hasta, tarih ya da dosya adı geçmez; notlar ile ölçüm ve açıklık adları yazıldıkları gibi kalır.</translation>
    </message>
    <message>
        <source>Not measured: run to the end.</source>
        <translation>Ölçülmedi: sona kadar çalıştırın.</translation>
    </message>
    <message>
        <source>★ marks what is better than in the other meshes.</source>
        <translation>★ öteki ağlardakinden iyi olanı gösterir.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>(on an earlier wall)</source>
        <translation>(önceki bir duvarda)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Ölçümler</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>İnceleme</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>kabul edildi</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>reddedildi</translation>
    </message>
    <message>
        <source>score %1 of %2</source>
        <translation>puan %1 / %2</translation>
    </message>
    <message>
        <source>given to an earlier segmentation</source>
        <translation>önceki bir bölütlemeye verildi</translation>
    </message>
    <message>
        <source>Doubtful places looked at: %1</source>
        <translation>Bakılan şüpheli yer: %1</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Yer</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puan</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Not</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Adım</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Süre, sn</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Uyarılar</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Adımlar</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametreler</translation>
    </message>
    <message>
        <source>Those that differ from the program&apos;s own are bold.</source>
        <translation>Programın kendi değerlerinden farklı olanlar kalındır.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Yöntemler</translation>
    </message>
</context>
<context>
    <name>Shortcut</name>
    <message>
        <source>Left drag on a slice</source>
        <translation>Kesitte sol tuşla sürükleme</translation>
    </message>
    <message>
        <source>Window and level (Engineering: crosshair; Ctrl: fine)</source>
        <translation>Pencere ve seviye (Mühendislik: artı imleç; Ctrl: ince)</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>Sol tık</translation>
    </message>
    <message>
        <source>Crosshair in all panes; in 3D on the surface</source>
        <translation>Tüm bölmelerde artı imleç; 3D&apos;de yüzey üzerinde</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Orta tuşla sürükleme</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Kaydırma</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Sağ tuşla sürükleme</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Yakınlaştırma</translation>
    </message>
    <message>
        <source>Wheel on a slice</source>
        <translation>Kesitte tekerlek</translation>
    </message>
    <message>
        <source>Next or previous slice</source>
        <translation>Sonraki veya önceki kesit</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+tekerlek</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+tekerlek</translation>
    </message>
    <message>
        <source>Slab thickness</source>
        <translation>Dilim kalınlığı</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Shift+hareket</translation>
    </message>
    <message>
        <source>Crosshair in all panes</source>
        <translation>Tüm bölmelerde artı imleç</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Sağ tık</translation>
    </message>
    <message>
        <source>Menu: windows; cut the vessel there; on a port: flip, rename, delete</source>
        <translation>Menü: pencereler; damarı orada kes; açıklıkta: çevir, adlandır, sil</translation>
    </message>
    <message>
        <source>Left drag on a port</source>
        <translation>Açıklığı sol tuşla sürükleme</translation>
    </message>
    <message>
        <source>Along the vessel (Shift: anywhere); by the arrow: tilt</source>
        <translation>Damar boyunca (Shift: her yere); oktan: eğme</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Çift tık</translation>
    </message>
    <message>
        <source>One pane at full size, and back</source>
        <translation>Bir bölme tam boyda, yeniden eski hâline</translation>
    </message>
    <message>
        <source>Arrow keys over a slice</source>
        <translation>Kesit üzerinde ok tuşları</translation>
    </message>
    <message>
        <source>Next or previous slice (Shift: by 10)</source>
        <translation>Sonraki veya önceki kesit (Shift: 10&apos;ar)</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset the pane under the mouse</source>
        <translation>Fare altındaki bölmeyi sıfırla</translation>
    </message>
    <message>
        <source>A, P, L, Shift+R, S, I over 3D</source>
        <translation>3D üzerinde A, P, L, Shift+R, S, I</translation>
    </message>
    <message>
        <source>Look from anterior, posterior, left, right, ...</source>
        <translation>Bakış yönü: ön, arka, sol, sağ, ...</translation>
    </message>
</context>
<context>
    <name>TriangleMeasure</name>
    <message>
        <source>2 * inradius / circumradius; 1 is equilateral</source>
        <translation>2 * iç yarıçap / çevrel yarıçap; eşkenarda 1</translation>
    </message>
    <message>
        <source>60 is equilateral</source>
        <translation>eşkenarda 60</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>En-boy oranı</translation>
    </message>
    <message>
        <source>Gap outside</source>
        <translation>Dış boşluk</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>En büyük açı</translation>
    </message>
    <message>
        <source>Radius ratio</source>
        <translation>Yarıçap oranı</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Pürüzlülük</translation>
    </message>
    <message>
        <source>Size gradation</source>
        <translation>Boyut geçişi</translation>
    </message>
    <message>
        <source>Skewness</source>
        <translation>Çarpıklık</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>En küçük açı</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Kalınlık</translation>
    </message>
    <message>
        <source>Valence, off 6</source>
        <translation>Valans, 6&apos;dan fark</translation>
    </message>
    <message>
        <source>distance of the vertices around from a smooth fit</source>
        <translation>çevredeki düğümlerin, uydurulan düzgün yüzeye uzaklığı</translation>
    </message>
    <message>
        <source>longest edge / (inradius * 12^0.5); 1 is equilateral</source>
        <translation>en uzun kenar / (iç yarıçap * 12^0.5); eşkenarda 1</translation>
    </message>
    <message>
        <source>mean edge over that of the neighbour that differs most, the larger over the smaller</source>
        <translation>ortalama kenarın, en farklı komşununkine oranı, büyük bölü küçük</translation>
    </message>
    <message>
        <source>of the angles; 0 is equilateral, 1 has no area</source>
        <translation>açıların; 0 eşkenar, 1 alansız</translation>
    </message>
    <message>
        <source>straight inwards to the other side of the vessel</source>
        <translation>dümdüz içeri, damarın öteki tarafına</translation>
    </message>
    <message>
        <source>straight outwards to the wall again, in edges of the triangle</source>
        <translation>dümdüz dışarı, yeniden duvara kadar, üçgenin kenarı cinsinden</translation>
    </message>
    <message>
        <source>triangles at a vertex against the 6 of an even mesh, at the worst corner</source>
        <translation>en kötü köşede, düğümdeki üçgen sayısının düzgün ağdaki 6&apos;dan farkı</translation>
    </message>
</context>
<context>
    <name>WindowPreset</name>
    <message>
        <source>From the file</source>
        <translation>Dosyadan</translation>
    </message>
    <message>
        <source>1st to 99.8th percentile</source>
        <translation>1. – 99.8. yüzdelik</translation>
    </message>
    <message>
        <source>CT angiography</source>
        <translation>BT anjiyografi</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Yumuşak doku</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Beyin</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Kemik</translation>
    </message>
</context>
<context>
    <name>angiomesh::Banner</name>
    <message>
        <source>Close</source>
        <translation>Kapat</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseCorrections</name>
    <message>
        <source>Add</source>
        <translation>Ekle</translation>
    </message>
    <message>
        <source>Add to the edge</source>
        <translation>Kenara kadar ekle</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Erase to the edge</source>
        <translation>Kenara kadar sil</translation>
    </message>
    <message>
        <source>Join two ends</source>
        <translation>İki ucu birleştir</translation>
    </message>
    <message>
        <source>Separate two vessels</source>
        <translation>İki damarı ayır</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Kesip at</translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation>Deliği doldur</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Döngüyü aç</translation>
    </message>
    <message>
        <source>remove a correction</source>
        <translation>düzeltmeyi kaldır</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: nothing changed.</source>
        <translation>%1: hiçbir şey değişmedi.</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseDialogs</name>
    <message>
        <source>1 change</source>
        <translation>1 değişiklik</translation>
    </message>
    <message>
        <source>%1 changes</source>
        <translation>%1 değişiklik</translation>
    </message>
    <message>
        <source>%1 of the case %2</source>
        <translation>%2 vakasında %1</translation>
    </message>
    <message>
        <source>%1 of a case that was never saved, the last one on %2</source>
        <translation>hiç kaydedilmemiş bir vakada %1, sonuncusu: %2</translation>
    </message>
    <message>
        <source>%1 of %2, which was never saved, the last one on %3</source>
        <translation>hiç kaydedilmemiş %2 üzerinde %1, sonuncusu: %3</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseDocument</name>
    <message>
        <source>change %1</source>
        <translation>değişiklik: %1</translation>
    </message>
    <message>
        <source>add a seed</source>
        <translation>tohum ekleme</translation>
    </message>
    <message>
        <source>remove a seed</source>
        <translation>tohum kaldırma</translation>
    </message>
    <message>
        <source>draw the region of interest</source>
        <translation>ilgi bölgesi çizme</translation>
    </message>
    <message>
        <source>clear the region of interest</source>
        <translation>ilgi bölgesini silme</translation>
    </message>
    <message>
        <source>move a seed</source>
        <translation>bir tohumu taşıma</translation>
    </message>
    <message>
        <source>this vessel only</source>
        <translation>yalnızca bu damar</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseFiles</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 series of %2 files</source>
        <translation>%1 serisi, %2 dosya</translation>
    </message>
    <message>
        <source>The case %1 is open already.</source>
        <translation>%1 vakası zaten açık.</translation>
    </message>
    <message>
        <source>Cannot open: %1</source>
        <translation>Açılamıyor: %1</translation>
    </message>
    <message>
        <source>Begins with the preset %1.</source>
        <translation>%1 ön ayarıyla başlıyor.</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>geri yüklenen</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Opened %1: %2%3.</source>
        <translation>%1 açıldı: %2%3.</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>Taken as a segmentation: its label %1%2, %3 voxels, is the vessel. For a scan choose another segmentation.method.</source>
        <translation>Bölütleme olarak alındı: damar, %3 vokselli %1%2 etiketidir. Çekim içinse başka bir segmentation.method seçin.</translation>
    </message>
    <message>
        <source>Restored a change that had not been saved.</source>
        <translation>Kaydedilmemiş bir değişiklik geri yüklendi.</translation>
    </message>
    <message>
        <source>Restored %1 changes that had not been saved.</source>
        <translation>Kaydedilmemiş %1 değişiklik geri yüklendi.</translation>
    </message>
    <message>
        <source>Saved the case %1.</source>
        <translation>%1 vakası kaydedildi.</translation>
    </message>
    <message>
        <source>Cannot save the case: %1</source>
        <translation>Vaka kaydedilemiyor: %1</translation>
    </message>
    <message>
        <source>Edits are not kept for a restore, save the case elsewhere: %1</source>
        <translation>Düzenlemeler geri yükleme için saklanamıyor, vakayı başka yere kaydedin: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseMeasures</name>
    <message>
        <source>Run to Evolve first: there is no wall to measure yet.</source>
        <translation>Önce Evrim adımına kadar çalıştırın: henüz ölçülecek duvar yok.</translation>
    </message>
    <message>
        <source>The case holds %1 measurements, which is the most: delete some first.</source>
        <translation>Vakada en çok bulunabilecek %1 ölçüm var: önce birkaçını silin.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Ölçülüyor…</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>yeniden ölçme</translation>
    </message>
    <message>
        <source>Not measured: %1</source>
        <translation>Ölçülmedi: %1</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>silme: %1</translation>
    </message>
    <message>
        <source>A measurement needs a name.</source>
        <translation>Bir ölçümün adı olmalıdır.</translation>
    </message>
    <message>
        <source>There is another measurement %1.</source>
        <translation>%1 adlı başka bir ölçüm var.</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>adlandırma: %1</translation>
    </message>
    <message>
        <source>Cannot export: %1</source>
        <translation>Dışa aktarılamıyor: %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 measurements.</source>
        <translation>%1 yazıldı: %2 ölçüm.</translation>
    </message>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>proximal</source>
        <translation>proksimal</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>taşıma: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::CasePorts</name>
    <message>
        <source>The vessel is cut there already: run to make the cut.</source>
        <translation>Damar orada zaten kesilmiş: kesimi yapmak için çalıştırın.</translation>
    </message>
    <message>
        <source>cut across %1</source>
        <translation>dik kesme: %1</translation>
    </message>
    <message>
        <source>import ports</source>
        <translation>açıklıkları içe aktarma</translation>
    </message>
    <message>
        <source>flip the cut %1</source>
        <translation>kesimi çevirme: %1</translation>
    </message>
    <message>
        <source>delete the cut %1</source>
        <translation>kesimi silme: %1</translation>
    </message>
    <message>
        <source>rename the cut %1 to %2</source>
        <translation>kesimi adlandırma: %1 → %2</translation>
    </message>
    <message>
        <source>name the opening %1 %2</source>
        <translation>açıklığı adlandırma: %1 → %2</translation>
    </message>
    <message>
        <source>tilt the cut %1</source>
        <translation>kesimi eğme: %1</translation>
    </message>
    <message>
        <source>move the cut %1</source>
        <translation>kesimi taşıma: %1</translation>
    </message>
    <message>
        <source>There are no vessels to cut yet: run to Evolve first.</source>
        <translation>Henüz kesilecek damar yok: önce Evrim adımına kadar çalıştırın.</translation>
    </message>
    <message>
        <source>add the cut %1</source>
        <translation>kesim ekleme: %1</translation>
    </message>
    <message>
        <source>No end was cut: no vessel ends in the volume without a cut already.</source>
        <translation>Hiçbir uç kesilmedi: hacim içinde kesimsiz biten damar yok.</translation>
    </message>
    <message>
        <source>Nothing was cut: at the volume&apos;s border no vessel is sliced any more.</source>
        <translation>Hiçbir şey kesilmedi: hacim sınırında artık eğik kesilen damar yok.</translation>
    </message>
    <message>
        <source>%1 places were not cut: the log says why.</source>
        <translation>%1 yer kesilmedi: nedeni günlükte.</translation>
    </message>
    <message>
        <source>cut all ends</source>
        <translation>tüm uçları kesme</translation>
    </message>
    <message>
        <source>cut all across</source>
        <translation>tümünü dik kesme</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseReviewModel</name>
    <message>
        <source>accept the segmentation</source>
        <translation>bölütlemeyi kabul</translation>
    </message>
    <message>
        <source>reject the segmentation</source>
        <translation>bölütlemeyi ret</translation>
    </message>
    <message>
        <source>take the verdict back</source>
        <translation>kararı geri alma</translation>
    </message>
    <message>
        <source>score the segmentation</source>
        <translation>bölütlemeye puan verme</translation>
    </message>
    <message>
        <source>add a remark</source>
        <translation>not ekleme</translation>
    </message>
    <message>
        <source>edit a remark</source>
        <translation>not düzenleme</translation>
    </message>
    <message>
        <source>remove a remark</source>
        <translation>not kaldırma</translation>
    </message>
    <message>
        <source>look at doubtful places</source>
        <translation>şüpheli yerlere bakma</translation>
    </message>
    <message>
        <source>No place of this segmentation is doubtful.</source>
        <translation>Bu bölütlemede şüpheli yer yok.</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseSensitivity</name>
    <message>
        <source>Open a scan first.</source>
        <translation>Önce bir tarama açın.</translation>
    </message>
    <message>
        <source>The wall of a segmentation depends on no such parameter.</source>
        <translation>Bir segmentasyonun duvarı böyle bir parametreye bağlı değildir.</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Largest move of the wall, mm</source>
        <translation>Duvarın en büyük kayması, mm</translation>
    </message>
    <message>
        <source>Move outwards, mm: %1</source>
        <translation>Dışa doğru kayma, mm: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::CentralArea</name>
    <message>
        <source>Open file…</source>
        <translation>Dosya aç…</translation>
    </message>
    <message>
        <source>Open DICOM folder…</source>
        <translation>DICOM klasörü aç…</translation>
    </message>
    <message>
        <source>Try the sample</source>
        <translation>Örneği dene</translation>
    </message>
</context>
<context>
    <name>angiomesh::ComponentTable</name>
    <message>
        <source>Part</source>
        <translation>Parça</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voksel</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Uzunluk</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Yarıçap</translation>
    </message>
    <message>
        <source>Of the centre lines, all branches, mm</source>
        <translation>Merkez hatlarının, tüm dallar, mm</translation>
    </message>
    <message>
        <source>Mean radius, mm</source>
        <translation>Ortalama yarıçap, mm</translation>
    </message>
    <message>
        <source>Left out by which parts are kept, or by the least volume</source>
        <translation>Tutulan parçalar ya da en az hacim nedeniyle dışarıda</translation>
    </message>
    <message>
        <source>Ticked off: not meshed</source>
        <translation>İşareti kaldırılmış: ağlanmaz</translation>
    </message>
    <message>
        <source>Parts: %1 (the largest %2 are listed)</source>
        <translation>Parçalar: %1 (en büyük %2 tanesi listede)</translation>
    </message>
    <message>
        <source>Parts: %1</source>
        <translation>Parçalar: %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::ConvergencePlot</name>
    <message>
        <source>Line: how far the front moves in an iteration, voxels; dots: its change at the checks; dashed: the tolerance. Click a mark below to see the front as it was then.</source>
        <translation>Çizgi: cephenin bir yinelemede ilerlediği yol, voksel; noktalar: denetimlerdeki değişimi; kesikli: tolerans. Cephenin o anki hâlini görmek için alttaki bir işareti tıklayın.</translation>
    </message>
    <message>
        <source>Change over iterations</source>
        <translation>Yinelemelere göre değişim</translation>
    </message>
    <message>
        <source>Iteration %1</source>
        <translation>Yineleme %1</translation>
    </message>
    <message>
        <source>, moves %1 voxel</source>
        <translation>, ilerleme %1 voksel</translation>
    </message>
    <message>
        <source>, change %1</source>
        <translation>, değişim %1</translation>
    </message>
    <message>
        <source>No evolution yet</source>
        <translation>Henüz evrim yok</translation>
    </message>
</context>
<context>
    <name>angiomesh::CorrectMenu</name>
    <message>
        <source>Add</source>
        <translation>Ekle</translation>
    </message>
    <message>
        <source>Paint what is missing of a vessel</source>
        <translation>Damarın eksik kısmını boyayın</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Paint over what is no vessel</source>
        <translation>Damar olmayanın üzerini boyayın</translation>
    </message>
    <message>
        <source>Join two ends</source>
        <translation>İki ucu birleştir</translation>
    </message>
    <message>
        <source>Click the two ends of a gap: they are joined along the vessel between them</source>
        <translation>Boşluğun iki ucuna tıklayın: aralarındaki damar boyunca birleştirilir</translation>
    </message>
    <message>
        <source>Separate two vessels</source>
        <translation>İki damarı ayır</translation>
    </message>
    <message>
        <source>Click each of two vessels that touch, beside the place</source>
        <translation>Birbirine değen iki damarın her birine, değdikleri yerin yanında tıklayın</translation>
    </message>
    <message>
        <source>Cut off the smaller side</source>
        <translation>Küçük tarafı kesip at</translation>
    </message>
    <message>
        <source>Ends the vessel at the crosshair; no port is made</source>
        <translation>Damarı artı imleçte bitirir; açıklık oluşturmaz</translation>
    </message>
    <message>
        <source>Fill the hole</source>
        <translation>Deliği doldur</translation>
    </message>
    <message>
        <source>Fills the cavity, or the hole through a vessel, at the crosshair</source>
        <translation>Artı işaretindeki boşluğu ya da damardaki deliği doldurur</translation>
    </message>
    <message>
        <source>Open the loop</source>
        <translation>Döngüyü aç</translation>
    </message>
    <message>
        <source>Cuts the loop whose thinnest place is nearest to the crosshair</source>
        <translation>En ince yeri artı imlece en yakın olan döngüyü keser</translation>
    </message>
    <message>
        <source>C&amp;orrect</source>
        <translation>&amp;Düzelt</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Daha küçük fırça</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Daha büyük fırça</translation>
    </message>
    <message>
        <source>Stop at the edge in the image</source>
        <translation>Görüntüdeki kenarda dur</translation>
    </message>
    <message>
        <source>The brush adds only what is as bright as a vessel, and erases only what is not</source>
        <translation>Fırça yalnızca damar kadar parlak olanı ekler, yalnızca öyle olmayanı siler</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Düzelt</translation>
    </message>
    <message>
        <source>Correct here</source>
        <translation>Burada düzelt</translation>
    </message>
    <message>
        <source>Add with the brush</source>
        <translation>Fırçayla ekle</translation>
    </message>
    <message>
        <source>Erase with the brush</source>
        <translation>Fırçayla sil</translation>
    </message>
    <message>
        <source>%1, from here</source>
        <translation>%1, buradan</translation>
    </message>
</context>
<context>
    <name>angiomesh::CorrectionList</name>
    <message>
        <source>%1. %2, %3</source>
        <translation>%1. %2, %3</translation>
    </message>
    <message>
        <source>%1 (left out)</source>
        <translation>%1 (atlandı)</translation>
    </message>
    <message>
        <source>%1 (%2 voxels)</source>
        <translation>%1 (%2 voksel)</translation>
    </message>
    <message>
        <source>Brush: </source>
        <translation>Fırça: </translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Fırçanın yarıçapı ([ ve ])</translation>
    </message>
    <message>
        <source>To the edge</source>
        <translation>Kenara kadar</translation>
    </message>
    <message>
        <source>The brush adds only what is as bright as a vessel, and erases only what is not</source>
        <translation>Fırça yalnızca damar kadar parlak olanı ekler, yalnızca öyle olmayanı siler</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Düzeltmeyi kaldır</translation>
    </message>
</context>
<context>
    <name>angiomesh::EvolutionControls</name>
    <message>
        <source>Pause</source>
        <translation>Duraklat</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Adım</translation>
    </message>
    <message>
        <source>%1 iterations, then pause again</source>
        <translation>%1 yineleme, sonra yine duraklat</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Bitir</translation>
    </message>
    <message>
        <source>Takes the surface as it stands</source>
        <translation>Yüzeyi olduğu gibi alır</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Sürdür</translation>
    </message>
    <message>
        <source>No iterations yet</source>
        <translation>Henüz yineleme yok</translation>
    </message>
    <message>
        <source>Iteration %1</source>
        <translation>Yineleme %1</translation>
    </message>
    <message>
        <source>Iteration %1, change %2</source>
        <translation>Yineleme %1, değişim %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::EvolutionPanel</name>
    <message>
        <source>Use this front</source>
        <translation>Bu cepheyi kullan</translation>
    </message>
    <message>
        <source>Ends the evolution at this iteration (levelset.stopAfter)</source>
        <translation>Evrimi bu yinelemede bitirir (levelset.stopAfter)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Geri</translation>
    </message>
    <message>
        <source>Shows the last front, or the result, again</source>
        <translation>Son cepheyi ya da sonucu yeniden gösterir</translation>
    </message>
    <message>
        <source>stop after iteration %1</source>
        <translation>şu yinelemeden sonra durma: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::ExportDialog</name>
    <message>
        <source>A DICOM segmentation (SEG): viewers lay it on the scan. It has the UIDs of the scan&apos;s images and of their frame of reference.</source>
        <translation>DICOM bölütlemesi (SEG): görüntüleyiciler çekimin üstüne koyar. Çekimin görüntülerinin ve referans çerçevelerinin UID&apos;lerini taşır.</translation>
    </message>
    <message>
        <source>1 in the voxels of the scan whose centre lies in the vessels, 0 in all others: it lies on the scan in any program.</source>
        <translation>Merkezi damarların içinde olan çekim voksellerinde 1, ötekilerde 0: her programda çekimin üstüne oturur.</translation>
    </message>
    <message>
        <source>A folder with the surface in metres, a patch for each port, and what OpenFOAM needs to fill it.</source>
        <translation>Metre cinsinden yüzeyi, her açıklık için bir yamayı ve OpenFOAM&apos;ın içini doldurmak için gerektirdiklerini içeren klasör.</translation>
    </message>
    <message>
        <source>DICOM segmentation (.dcm)</source>
        <translation>DICOM bölütlemesi (.dcm)</translation>
    </message>
    <message>
        <source>%1, binary</source>
        <translation>%1, ikili</translation>
    </message>
    <message>
        <source>%1, ASCII</source>
        <translation>%1, ASCII</translation>
    </message>
    <message>
        <source>OpenFOAM case</source>
        <translation>OpenFOAM vakası</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Dışa aktar…</translation>
    </message>
    <message>
        <source>What</source>
        <translation>İçerik</translation>
    </message>
    <message>
        <source>Mesh, %1</source>
        <translation>Ağ, %1</translation>
    </message>
    <message>
        <source>Mask of the vessels</source>
        <translation>Damarların maskesi</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Biçim</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Birim</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milimetre</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metre</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Çerçeve</translation>
    </message>
    <message>
        <source>LPS (DICOM, ITK)</source>
        <translation>LPS (DICOM, ITK)</translation>
    </message>
    <message>
        <source>RAS (NIfTI, Slicer)</source>
        <translation>RAS (NIfTI, Slicer)</translation>
    </message>
    <message>
        <source>Size of the result</source>
        <translation>Sonucun boyutu</translation>
    </message>
    <message>
        <source>Normals of the vertices</source>
        <translation>Düğümlerin normalleri</translation>
    </message>
    <message>
        <source>Quality of the triangles (radius ratio)</source>
        <translation>Üçgenlerin kalitesi (yarıçap oranı)</translation>
    </message>
    <message>
        <source>Write NAME.report.json beside it</source>
        <translation>Yanına AD.report.json yaz</translation>
    </message>
    <message>
        <source>Write NAME.ports.json beside it: where the ports lie</source>
        <translation>Yanına AD.ports.json yaz: açıklıkların yerleri</translation>
    </message>
    <message>
        <source>Write each patch to a file of its own, too</source>
        <translation>Her yamayı ayrıca kendi dosyasına yaz</translation>
    </message>
    <message>
        <source>With the patient&apos;s identity</source>
        <translation>Hastanın kimliğiyle</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>⚠ The file will name the patient and the study, as the images of the scan do: a PACS files it with them.</source>
        <translation>⚠ Dosya, çekimin görüntüleri gibi, hastanın ve incelemenin adını taşır: PACS dosyayı onlarla birlikte saklar.</translation>
    </message>
    <message>
        <source>Patient and study are left empty: tick the identity for a PACS to file it with the scan.</source>
        <translation>Hasta ve inceleme boş bırakılır: PACS çekimle birlikte saklasın diye kimliği işaretleyin.</translation>
    </message>
    <message>
        <source>The segmentation in work is not done: the one before is exported.</source>
        <translation>Yapılmakta olan bölütleme bitmedi: bir önceki dışa aktarılır.</translation>
    </message>
    <message>
        <source>The segmentation belongs to earlier parameters: run again for the present ones.</source>
        <translation>Bölütleme önceki parametrelere ait: şimdikiler için yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>The mesh belongs to earlier parameters: run again for the present ones.</source>
        <translation>Ağ önceki parametrelere ait: şimdikiler için yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>⚠ It loses the names of the %1 ports: STL, ASCII has them.</source>
        <translation>⚠ %1 açıklığın adı kaybolur: STL, ASCII adları saklar.</translation>
    </message>
    <message>
        <source>⚠ This mesh cuts itself or is no manifold: a flow solver will refuse it. Marching cubes of the same level set may do.</source>
        <translation>⚠ Bu ağ kendini kesiyor ya da manifold değil: akış çözücü kabul etmez. Aynı düzey kümesinin marching cubes ağı işe yarayabilir.</translation>
    </message>
    <message>
        <source>⚠ This mesh has no ports: nothing could flow in or out.</source>
        <translation>⚠ Bu ağda açıklık yok: hiçbir şey içeri ya da dışarı akamaz.</translation>
    </message>
    <message>
        <source>⚠ The mesh is not closed: choose surface.border = cap.</source>
        <translation>⚠ Ağ kapalı değil: surface.border = cap seçin.</translation>
    </message>
    <message>
        <source>⚠ The surface has %1 parts that are not connected, and OpenFOAM fills one: tick the others off, or set segmentation.keep.</source>
        <translation>⚠ Yüzeyin birbirine bağlı olmayan %1 parçası var, OpenFOAM ise birini doldurur: ötekilerin işaretini kaldırın ya da segmentation.keep ayarlayın.</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Klasörler (*)</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
</context>
<context>
    <name>angiomesh::Exports</name>
    <message>
        <source>This surface is not fit for a solver: %1. Look at that place in the image, and smooth more or choose another surface method.</source>
        <translation>Bu yüzey çözücüye uygun değil: %1. Görüntüde o yere bakın; daha çok yumuşatın ya da başka bir yüzey yöntemi seçin.</translation>
    </message>
    <message>
        <source>This segmentation belongs to earlier parameters: run again for the present ones.</source>
        <translation>Bu bölütleme önceki parametrelere ait: şimdikiler için yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>These ports belong to earlier parameters: run again for the present ones.</source>
        <translation>Bu açıklıklar önceki parametrelere ait: şimdikiler için yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>An export is being written: try again when it is done.</source>
        <translation>Bir dışa aktarma yazılıyor: bitince yeniden deneyin.</translation>
    </message>
    <message>
        <source>There is no segmentation to export: run the pipeline first.</source>
        <translation>Dışa aktarılacak bölütleme yok: önce işlem hattını çalıştırın.</translation>
    </message>
    <message>
        <source>There is no mesh to export: run the pipeline first.</source>
        <translation>Dışa aktarılacak ağ yok: önce işlem hattını çalıştırın.</translation>
    </message>
    <message>
        <source>Cannot export: %1</source>
        <translation>Dışa aktarılamıyor: %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 openings.</source>
        <translation>%1 yazıldı: %2 açıklık.</translation>
    </message>
    <message>
        <source>Wrote the OpenFOAM case %1. Its script Allrun fills it.</source>
        <translation>OpenFOAM vakası %1 yazıldı. İçindeki Allrun betiği onu doldurur.</translation>
    </message>
    <message>
        <source>Wrote %1. Read back: a mask of %2 voxels (%3 ml) in %4.</source>
        <translation>%1 yazıldı. Geri okunan: %2 voksellik maske (%3 ml); ızgara: %4.</translation>
    </message>
    <message>
        <source>its report</source>
        <translation>raporu</translation>
    </message>
    <message>
        <source>its ports</source>
        <translation>açıklıkları</translation>
    </message>
    <message>
        <source>%1 files of single patches</source>
        <translation>tek yamalı %1 dosya</translation>
    </message>
    <message>
        <source>Wrote %1%2. Read back: %3 vertices, %4 triangles, %5, %6 in %7.</source>
        <translation>%1%2 yazıldı. Geri okunan: %3 düğüm, %4 üçgen, %5, %6 (%7).</translation>
    </message>
    <message>
        <source> and </source>
        <translation> ve </translation>
    </message>
    <message>
        <source>closed</source>
        <translation>kapalı</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>kapalı değil</translation>
    </message>
</context>
<context>
    <name>angiomesh::FieldEditor</name>
    <message>
        <source>Clear</source>
        <translation>Temizle</translation>
    </message>
    <message>
        <source>Larger: %1.</source>
        <translation>Artırılınca: %1.</translation>
    </message>
    <message>
        <source>Has no effect now: %1.</source>
        <translation>Şu anda etkisiz: %1.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>noktalar: %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>verildi</translation>
    </message>
    <message>
        <source>on</source>
        <translation>açık</translation>
    </message>
    <message>
        <source>off</source>
        <translation>kapalı</translation>
    </message>
    <message>
        <source>Changed. Back to %1, as in the preset %2.</source>
        <translation>Değiştirildi. %2 ön ayarındaki gibi %1 değerine dön.</translation>
    </message>
</context>
<context>
    <name>angiomesh::GateList</name>
    <message>
        <source>Smaller ρ (× 0.7)</source>
        <translation>Daha küçük ρ (× 0.7)</translation>
    </message>
    <message>
        <source>Sets surface.rho: more triangles, which follow the wall more closely</source>
        <translation>surface.rho ayarlar: duvarı daha yakından izleyen, daha çok üçgen</translation>
    </message>
    <message>
        <source>Keep the largest part only</source>
        <translation>Yalnız en büyük parçayı tut</translation>
    </message>
    <message>
        <source>Sets segmentation.keep; single parts are unticked in the table of parts</source>
        <translation>segmentation.keep ayarlar; tek tek parçaların işareti parça tablosunda kaldırılır</translation>
    </message>
    <message>
        <source>Close the ends</source>
        <translation>Uçları kapat</translation>
    </message>
    <message>
        <source>Sets surface.border to cap</source>
        <translation>surface.border değerini cap yapar</translation>
    </message>
    <message>
        <source>Use the advancing front</source>
        <translation>İlerleyen cepheyi kullan</translation>
    </message>
    <message>
        <source>Sets surface.method to advancing-front</source>
        <translation>surface.method değerini advancing-front yapar</translation>
    </message>
    <message>
        <source>Close thin loops</source>
        <translation>İnce döngüleri kapat</translation>
    </message>
    <message>
        <source>Sets wall.smooth: holes and handles that noise explains are closed</source>
        <translation>wall.smooth ayarlar: gürültünün açıkladığı delik ve kulplar kapatılır</translation>
    </message>
    <message>
        <source>A parameter has changed: run again.</source>
        <translation>Bir parametre değişti: yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: not measured yet</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: henüz ölçülmedi</translation>
    </message>
    <message>
        <source>Loops: %1. Vessels may join in rings; or two that touch have grown together. A smooth wall closes thin loops, and Cut vessel parts two vessels.</source>
        <translation>Döngüler: %1. Damarlar halka oluşturabilir ya da birbirine değen ikisi birleşmiş olabilir. Düzgün duvar ince döngüleri kapatır, Damarı kes iki damarı ayırır.</translation>
    </message>
</context>
<context>
    <name>angiomesh::Guide</name>
    <message>
        <source>Guide</source>
        <translation>Kılavuz</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Kısayollar</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>Tüm sayfalarda ara</translation>
    </message>
    <message>
        <source>Key or mouse</source>
        <translation>Tuş veya fare</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>İşlevi</translation>
    </message>
</context>
<context>
    <name>angiomesh::HistogramWidget</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>No mesh yet</source>
        <translation>Henüz ağ yok</translation>
    </message>
    <message>
        <source>%1 (% of triangles)</source>
        <translation>%1 (üçgenlerin % payı)</translation>
    </message>
</context>
<context>
    <name>angiomesh::InspectorPanel</name>
    <message>
        <source>Compare</source>
        <translation>Karşılaştır</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Koşullar</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Üçgenler</translation>
    </message>
    <message>
        <source>Mesh shown</source>
        <translation>Gösterilen ağ</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>düz</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Renk</translation>
    </message>
    <message>
        <source>A click on a bar lights its triangles up in 3D; drag for more bars</source>
        <translation>Bir çubuğa tıklamak üçgenlerini 3D&apos;de aydınlatır; daha çok çubuk için sürükleyin</translation>
    </message>
    <message>
        <source>Worst of the mesh shown</source>
        <translation>Gösterilen ağın en kötüleri</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Sonuç %1</translation>
    </message>
    <message>
        <source>◐ %1 belongs to earlier parameters: run again.</source>
        <translation>◐ %1 önceki parametrelere ait: yeniden çalıştırın.</translation>
    </message>
    <message>
        <source>Quality is not measured yet: run to the end.</source>
        <translation>Kalite henüz ölçülmedi: sona kadar çalıştırın.</translation>
    </message>
    <message>
        <source>No mesh yet: open a volume and press Run.</source>
        <translation>Henüz ağ yok: bir hacim açıp Çalıştır düğmesine basın.</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>kapalı</translation>
    </message>
    <message>
        <source>open, rims: %1</source>
        <translation>açık, ağız: %1</translation>
    </message>
    <message>
        <source>manifold</source>
        <translation>manifold</translation>
    </message>
    <message>
        <source>not manifold: a solver refuses it</source>
        <translation>manifold değil: çözücü kabul etmez</translation>
    </message>
    <message>
        <source>no self-intersections</source>
        <translation>kendiyle kesişme yok</translation>
    </message>
    <message>
        <source>%1 self-intersections</source>
        <translation>%1 kendiyle kesişme</translation>
    </message>
    <message>
        <source>no degenerate triangles</source>
        <translation>dejenere üçgen yok</translation>
    </message>
    <message>
        <source>%1 degenerate triangles</source>
        <translation>%1 dejenere üçgen</translation>
    </message>
    <message>
        <source>%1 parts not verified</source>
        <translation>%1 parça doğrulanmadı</translation>
    </message>
    <message>
        <source>Compares a mesh from a file (PLY, STL, OBJ, OFF, VTP, VTK) with these</source>
        <translation>Dosyadan bir ağı (PLY, STL, OBJ, OFF, VTP, VTK) bunlarla karşılaştırır</translation>
    </message>
    <message>
        <source>Beside it</source>
        <translation>Yanında</translation>
    </message>
    <message>
        <source>Mesh from a file</source>
        <translation>Dosyadan ağ</translation>
    </message>
</context>
<context>
    <name>angiomesh::LabelDialog</name>
    <message>
        <source>Choose a label</source>
        <translation>Etiket seç</translation>
    </message>
    <message>
        <source>This is a segmentation with %1 labels. Which one is the vessel?</source>
        <translation>Bu, %1 etiketli bir bölütlemedir. Damar hangisi?</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiket</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voksel</translation>
    </message>
    <message>
        <source>Volume, ml</source>
        <translation>Hacim, ml</translation>
    </message>
    <message>
        <source>Open the label</source>
        <translation>Etiketi aç</translation>
    </message>
    <message>
        <source>It is a scan</source>
        <translation>Bu bir çekim</translation>
    </message>
</context>
<context>
    <name>angiomesh::LivePreview</name>
    <message>
        <source>open a scan first</source>
        <translation>önce bir tarama açın</translation>
    </message>
    <message>
        <source>a run is on</source>
        <translation>hesaplanıyor</translation>
    </message>
    <message>
        <source>evolving…</source>
        <translation>evriliyor…</translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation>%1 sn</translation>
    </message>
    <message>
        <source>level set only</source>
        <translation>yalnız düzey kümesi</translation>
    </message>
    <message>
        <source>run once first</source>
        <translation>önce çalıştırın</translation>
    </message>
    <message>
        <source>run anew first</source>
        <translation>yeniden çalıştırın</translation>
    </message>
    <message>
        <source>move a slider below</source>
        <translation>alttan bir ayar değiştirin</translation>
    </message>
</context>
<context>
    <name>angiomesh::LogPanel</name>
    <message>
        <source>Warning: </source>
        <translation>Uyarı: </translation>
    </message>
    <message>
        <source>Error: </source>
        <translation>Hata: </translation>
    </message>
</context>
<context>
    <name>angiomesh::MainWindow</name>
    <message>
        <source>Pipeline</source>
        <translation>İşlem hattı</translation>
    </message>
    <message>
        <source>Mesh inspector</source>
        <translation>Ağ denetimi</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>Açıklıklar</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Günlük</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Yakınsama</translation>
    </message>
    <message>
        <source>Why here?</source>
        <translation>Neden böyle?</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Ölçümler</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>İnceleme</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Dü&amp;zen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Geri al</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Yinele</translation>
    </message>
    <message>
        <source>Remove all seeds by hand</source>
        <translation>Elle konan tüm tohumları kaldır</translation>
    </message>
    <message>
        <source>Clear region of interest</source>
        <translation>İlgi bölgesini sil</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Görünüm</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Yardım</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Kısayollar</translation>
    </message>
    <message>
        <source>About Angiomesh</source>
        <translation>Angiomesh hakkında</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Dosya</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Aç…</translation>
    </message>
    <message>
        <source>Open folder or case…</source>
        <translation>Klasör veya vaka aç…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation>Örneği aç</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Son açılanlar</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>Vakayı kaydet</translation>
    </message>
    <message>
        <source>Save case as…</source>
        <translation>Vakayı farklı kaydet…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Dışa aktar…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Çık</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Duraklat</translation>
    </message>
    <message>
        <source>%1[*] — Angiomesh</source>
        <translation>%1[*] — Angiomesh</translation>
    </message>
    <message>
        <source>Angiomesh</source>
        <translation>Angiomesh</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Sürdür</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Yükleniyor</translation>
    </message>
    <message>
        <source>%1: iteration %2</source>
        <translation>%1: yineleme %2</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, %1 kaldı</translation>
    </message>
    <message>
        <source>Turntable: picture %1 of %2</source>
        <translation>Döner görünüm: resim %1 / %2</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Kılavuz</translation>
    </message>
    <message>
        <source>Patient of this scan…</source>
        <translation>Bu çekimin hastası…</translation>
    </message>
    <message>
        <source>Compare with a mesh…</source>
        <translation>Bir ağla karşılaştır…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Report on the mesh…</source>
        <translation>Ağ raporu…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Web sayfası (*.html)</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Bunları unut</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Duyarlılık</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeasureMenu</name>
    <message>
        <source>Distance</source>
        <translation>Mesafe</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>En kesit</translation>
    </message>
    <message>
        <source>Diameter along a branch</source>
        <translation>Dal boyunca çap</translation>
    </message>
    <message>
        <source>Stenosis</source>
        <translation>Stenoz</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Ö&amp;lçüm</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Yeniden ölç</translation>
    </message>
    <message>
        <source>At the same places, on the wall that is shown</source>
        <translation>Aynı yerlerde, gösterilen duvar üzerinde</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Adlandır</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>CSV&apos;ye aktar…</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Ölçüm</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Virgülle ayrılmış değerler (*.csv)</translation>
    </message>
    <message>
        <source>Measure here</source>
        <translation>Burada ölç</translation>
    </message>
    <message>
        <source>%1 from here</source>
        <translation>Buradan: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeasurePanel</name>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Değer</translation>
    </message>
    <message>
        <source>Nothing is measured: choose a tool of the menu Measure.</source>
        <translation>Hiçbir şey ölçülmedi: Ölçüm menüsünden bir araç seçin.</translation>
    </message>
    <message>
        <source>⚠ of earlier parameters</source>
        <translation>⚠ önceki parametrelerden</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshChooser</name>
    <message>
        <source>The mesh in this view</source>
        <translation>Bu görünümdeki ağ</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Böl</translation>
    </message>
    <message>
        <source>Linked</source>
        <translation>Bağlı</translation>
    </message>
    <message>
        <source>Shows another mesh beside this one; drag the bar between them</source>
        <translation>Bunun yanında başka bir ağ gösterir; aradaki çubuk sürüklenir</translation>
    </message>
    <message>
        <source>Both views turn, move and zoom as one</source>
        <translation>İki görünüm birlikte döner, kayar ve büyür</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshFile</name>
    <message>
        <source>Cannot compare with this mesh: %1</source>
        <translation>Bu ağla karşılaştırılamıyor: %1</translation>
    </message>
    <message>
        <source>%1: %2 triangles, compared with the meshes of the case.</source>
        <translation>%1: %2 üçgen, vakanın ağlarıyla karşılaştırıldı.</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshReport</name>
    <message>
        <source>A report is being written: try again when it is done.</source>
        <translation>Bir rapor yazılıyor: bitince yeniden deneyin.</translation>
    </message>
    <message>
        <source>There is no mesh to report on: run the pipeline first.</source>
        <translation>Raporu yazılacak ağ yok: önce işlem hattını çalıştırın.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kalite</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Koşullar</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Üçgenler</translation>
    </message>
    <message>
        <source>This pane was never drawn.</source>
        <translation>Bu bölme hiç çizilmedi.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Resimler</translation>
    </message>
    <message>
        <source>%1, through the crosshair</source>
        <translation>%1, artı imleçten geçen</translation>
    </message>
    <message>
        <source>Projection of the image, as the 3D pane looks</source>
        <translation>Görüntünün izdüşümü, 3D bölmenin bakış yönünde</translation>
    </message>
    <message>
        <source>Surface, from the same side</source>
        <translation>Yüzey, aynı taraftan</translation>
    </message>
    <message>
        <source>Surface, turned by %1°</source>
        <translation>Yüzey, %1° döndürülmüş</translation>
    </message>
    <message>
        <source>Per cent of the triangles, and in bands</source>
        <translation>Üçgenlerin yüzdesi; ayrıca aralıklara göre</translation>
    </message>
    <message>
        <source>Cannot write the report: %1</source>
        <translation>Rapor yazılamıyor: %1</translation>
    </message>
    <message>
        <source>Wrote the report %1.</source>
        <translation>%1 raporu yazıldı.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PaneMenu</name>
    <message>
        <source>Show hidden parts</source>
        <translation>Gizli parçaları göster</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Hide this part</source>
        <translation>Bu parçayı gizle</translation>
    </message>
    <message>
        <source>Keep only this part</source>
        <translation>Yalnız bu parçayı tut</translation>
    </message>
    <message>
        <source>Ticks all other parts off</source>
        <translation>Öteki tüm parçaların işaretini kaldırır</translation>
    </message>
    <message>
        <source>Remove this part</source>
        <translation>Bu parçayı kaldır</translation>
    </message>
    <message>
        <source>Ticks it off</source>
        <translation>İşaretini kaldırır</translation>
    </message>
    <message>
        <source>Slab of this pane</source>
        <translation>Bu bölmenin dilimi</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Kapalı</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Ortalama</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Kalınlık</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The same in all panes</source>
        <translation>Tüm bölmelerde aynısı</translation>
    </message>
</context>
<context>
    <name>angiomesh::PaneTools</name>
    <message>
        <source>Overlay</source>
        <translation>Bindirme</translation>
    </message>
    <message>
        <source>Slices in 3D</source>
        <translation>3D&apos;de kesitler</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Slice planes</source>
        <translation>Kesit düzlemleri</translation>
    </message>
    <message>
        <source>Along the patient&apos;s axes</source>
        <translation>Hastanın eksenleri boyunca</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Turn back</source>
        <translation>Geri döndür</translation>
    </message>
    <message>
        <source>  Overlay </source>
        <translation>  Bindirme </translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
    <message>
        <source>Opacity of the overlay</source>
        <translation>Bindirmenin opaklığı</translation>
    </message>
</context>
<context>
    <name>angiomesh::PatientIdentity</name>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>Hasta kimlik no</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Doğum tarihi</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Cinsiyet</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>İnceleme tarihi</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>İnceleme</translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation>Erişim numarası</translation>
    </message>
    <message>
        <source>Patient of this scan</source>
        <translation>Bu çekimin hastası</translation>
    </message>
    <message>
        <source>Read from the files now. Angiomesh keeps none of it.</source>
        <translation>Şimdi dosyalardan okundu. Angiomesh bunların hiçbirini saklamaz.</translation>
    </message>
    <message>
        <source>Cannot read the patient&apos;s identity: %1</source>
        <translation>Hastanın kimliği okunamıyor: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::PictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>Resmi kaydet</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopyala</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Kaydet…</translation>
    </message>
    <message>
        <source>all panes</source>
        <translation>tüm bölmeler</translation>
    </message>
    <message>
        <source>turntable of the 3D pane</source>
        <translation>3D bölmenin döner görünümü</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Neyin resmi</translation>
    </message>
    <message>
        <source>as on the screen</source>
        <translation>ekrandaki gibi</translation>
    </message>
    <message>
        <source>twice as large</source>
        <translation>iki kat büyük</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Boyut</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Piksel</translation>
    </message>
    <message>
        <source>%1, every %2°</source>
        <translation>%1, %2° arayla</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Resimler</translation>
    </message>
    <message>
        <source>With the crosshair</source>
        <translation>Artı imleçle</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::Pictures</name>
    <message>
        <source>Save picture…</source>
        <translation>Resmi kaydet…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Resmi kopyala</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copied a picture of %1 × %2 pixels.</source>
        <translation>%1 × %2 piksellik resim kopyalandı.</translation>
    </message>
    <message>
        <source>Pictures are being written: try again when they are done.</source>
        <translation>Resimler yazılıyor: bitince yeniden deneyin.</translation>
    </message>
    <message>
        <source>Folders NAME-turntable (*)</source>
        <translation>AD-turntable klasörleri (*)</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Cannot save the picture: %1</source>
        <translation>Resim kaydedilemiyor: %1</translation>
    </message>
    <message>
        <source>Saved %1, %2 × %3 pixels.</source>
        <translation>%1 kaydedildi, %2 × %3 piksel.</translation>
    </message>
    <message>
        <source>Gave up the turntable: nothing of it was kept.</source>
        <translation>Döner görünümden vazgeçildi: hiçbir şey saklanmadı.</translation>
    </message>
    <message>
        <source>Saved the %1 pictures of %2, %3 × %4 pixels.</source>
        <translation>%2 için %1 resim kaydedildi, %3 × %4 piksel.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PipelinePanel</name>
    <message>
        <source>Preset</source>
        <translation>Ön ayar</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Çalıştır</translation>
    </message>
    <message>
        <source>Runs the whole pipeline; what is fresh is not computed again</source>
        <translation>Tüm işlem hattını çalıştırır; güncel olan yeniden hesaplanmaz</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>İptal</translation>
    </message>
    <message>
        <source>✕ %1 failed: %2</source>
        <translation>✕ %1 başarısız: %2</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Canlı</translation>
    </message>
    <message>
        <source>Tries what is changed below Seeds at once, in a box around the crosshair. The result stays as it is until you run.</source>
        <translation>Tohumlar adımının altındaki değişiklikleri artı imleç çevresindeki kutuda hemen dener. Siz çalıştırana kadar sonuç değişmez.</translation>
    </message>
    <message>
        <source>Side of the box in voxels: a smaller one answers faster</source>
        <translation>Kutunun voksel cinsinden kenarı: küçük kutu daha hızlı yanıt verir</translation>
    </message>
    <message>
        <source>Save, remove, import and export presets</source>
        <translation>Ön ayarları kaydet, kaldır, içe ve dışa aktar</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, değiştirildi</translation>
    </message>
</context>
<context>
    <name>angiomesh::PortMenu</name>
    <message>
        <source>P&amp;orts</source>
        <translation>Açı&amp;klıklar</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Buradan kes</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Cuts the vessel at the crosshair (Ctrl+K)</source>
        <translation>Damarı artı imleçte keser (Ctrl+K)</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Dik kes</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Ends the vessel across just inside an opening that slices it (Ctrl+Alt+K)</source>
        <translation>Damarı, onu eğik kesen bir açıklığın hemen içinde dik bitirir (Ctrl+Alt+K)</translation>
    </message>
    <message>
        <source>Cut all ends…</source>
        <translation>Tüm uçları kes…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Cut all across</source>
        <translation>Tümünü dik kes</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+K</source>
        <translation>Ctrl+Alt+Shift+K</translation>
    </message>
    <message>
        <source>Ends all vessels across that the volume&apos;s border slices (Ctrl+Alt+Shift+K)</source>
        <translation>Hacim sınırının eğik kestiği tüm damarları dik bitirir (Ctrl+Alt+Shift+K)</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Çevir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Cuts away the other side (Ctrl+Shift+F)</source>
        <translation>Öteki tarafı kesip çıkarır (Ctrl+Shift+F)</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Adlandır</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Import ports…</source>
        <translation>İçe aktar…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>Export ports…</source>
        <translation>Dışa aktar…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Why here?</source>
        <translation>Neden böyle?</translation>
    </message>
    <message>
        <source>Cut all ends</source>
        <translation>Tüm uçları kes</translation>
    </message>
    <message>
        <source>Each vessel that ends in the volume gets a cut, which can be edited.
How far before its tip, in radii of the vessel:</source>
        <translation>Hacim içinde biten her damara, düzenlenebilen bir kesim konur.
Ucundan ne kadar önce, damar yarıçapı cinsinden:</translation>
    </message>
    <message>
        <source>Ports (*.json)</source>
        <translation>Açıklıklar (*.json)</translation>
    </message>
</context>
<context>
    <name>angiomesh::PortPanel</name>
    <message>
        <source>Port</source>
        <translation>Açıklık</translation>
    </message>
    <message>
        <source>Ø mm</source>
        <translation>Ø mm</translation>
    </message>
    <message>
        <source>mm²</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Durum</translation>
    </message>
    <message>
        <source>Diameter of the circle of the same area</source>
        <translation>Aynı alanlı çemberin çapı</translation>
    </message>
    <message>
        <source>No ports: put the crosshair into a vessel and press Cut here, or right-click one.</source>
        <translation>Açıklık yok: artı imleci bir damara koyup Buradan kes düğmesine basın ya da bir damara sağ tıklayın.</translation>
    </message>
    <message>
        <source>Run to Evolve, then cut the vessels here.</source>
        <translation>Evrim adımına kadar çalıştırın, sonra damarları burada kesin.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetDialog</name>
    <message>
        <source>Save as a preset</source>
        <translation>Ön ayar olarak kaydet</translation>
    </message>
    <message>
        <source>All parameters are kept, but not seeds, region of interest, cuts and corrections: these belong to one scan. Do not write a patient&apos;s name.</source>
        <translation>Tüm parametreler saklanır; tohumlar, ilgi bölgesi, kesitler ve düzeltmeler saklanmaz: bunlar tek bir taramaya aittir. Hasta adı yazmayın.</translation>
    </message>
    <message>
        <source>such as the scanner or the region</source>
        <translation>örneğin cihaz ya da bölge</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ad</translation>
    </message>
    <message>
        <source>What it is for</source>
        <translation>Ne için</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Kaydet</translation>
    </message>
    <message>
        <source>It replaces the preset of this name.</source>
        <translation>Bu addaki ön ayarın yerini alır.</translation>
    </message>
    <message>
        <source>%1 comes with the program: choose another name.</source>
        <translation>%1 programla birlikte gelir: başka bir ad seçin.</translation>
    </message>
    <message>
        <source>Saved the preset %1.</source>
        <translation>%1 ön ayarı kaydedildi.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetMenu</name>
    <message>
        <source>Presets</source>
        <translation>Ön ayarlar</translation>
    </message>
    <message>
        <source>Save as a preset…</source>
        <translation>Ön ayar olarak kaydet…</translation>
    </message>
    <message>
        <source>Remove this preset…</source>
        <translation>Bu ön ayarı kaldır…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>Ön ayarı içe aktar…</translation>
    </message>
    <message>
        <source>Export this preset…</source>
        <translation>Bu ön ayarı dışa aktar…</translation>
    </message>
    <message>
        <source>There is a preset %1 with these parameters.</source>
        <translation>Bu parametrelerle bir %1 ön ayarı var.</translation>
    </message>
    <message>
        <source>%1 (imported)</source>
        <translation>%1 (içe aktarıldı)</translation>
    </message>
    <message>
        <source>Cannot import the preset: %1</source>
        <translation>Ön ayar içe aktarılamıyor: %1</translation>
    </message>
    <message>
        <source>Imported the preset %1.</source>
        <translation>%1 ön ayarı içe aktarıldı.</translation>
    </message>
    <message>
        <source>Presets (*.preset.json *.json)</source>
        <translation>Ön ayarlar (*.preset.json *.json)</translation>
    </message>
    <message>
        <source>Cannot write the preset: %1</source>
        <translation>Ön ayar yazılamıyor: %1</translation>
    </message>
    <message>
        <source>Wrote the preset %1: angiomesh-cli run SCAN --params %1 begins with it.</source>
        <translation>%1 ön ayarı yazıldı: angiomesh-cli run SCAN --params %1 onunla başlar.</translation>
    </message>
    <message>
        <source>Removed the preset %1.</source>
        <translation>%1 ön ayarı kaldırıldı.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetShelf</name>
    <message>
        <source>preset %1</source>
        <translation>ön ayar: %1</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Bir ön ayarın adı olmalı.</translation>
    </message>
    <message>
        <source>The name is too long: at most %1 letters.</source>
        <translation>Ad çok uzun: en fazla %1 harf.</translation>
    </message>
    <message>
        <source>%1 comes with the program: choose another name.</source>
        <translation>%1 programla birlikte gelir: başka bir ad seçin.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ProfilePlot</name>
    <message>
        <source>Diameter along the centre line: of the circle as large as the section and, thin, the least one. A click goes there.</source>
        <translation>Merkez hattı boyunca çap: en kesitle eş alanlı çemberin çapı; ince çizgi: en küçük çap. Tıklanan yere gidilir.</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Çap, mm</translation>
    </message>
    <message>
        <source>along the centre line, mm</source>
        <translation>merkez hattı boyunca, mm</translation>
    </message>
</context>
<context>
    <name>angiomesh::QualityGrid</name>
    <message>
        <source>The best of the meshes compared</source>
        <translation>Karşılaştırılan ağların en iyisi</translation>
    </message>
</context>
<context>
    <name>angiomesh::RecipeActions</name>
    <message>
        <source>Recipe…</source>
        <translation>Tarif…</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Komut satırı olarak kopyala</translation>
    </message>
    <message>
        <source>Copy methods paragraph</source>
        <translation>Yöntem paragrafını kopyala</translation>
    </message>
    <message>
        <source>Recipes (*.recipe.json *.json)</source>
        <translation>Tarifler (*.recipe.json *.json)</translation>
    </message>
    <message>
        <source>Cannot write the recipe: %1</source>
        <translation>Tarif yazılamıyor: %1</translation>
    </message>
    <message>
        <source>Wrote the recipe %1: angiomesh-cli run SCAN --recipe %1 makes the same mesh.</source>
        <translation>%1 tarifi yazıldı: angiomesh-cli run SCAN --recipe %1 aynı ağı oluşturur.</translation>
    </message>
    <message>
        <source>Copied the command line that repeats this case: put the volume in place of SCAN and a folder in place of OUT.</source>
        <translation>Bu vakayı yineleyen komut satırı kopyalandı: SCAN yerine hacmi, OUT yerine bir klasör yazın.</translation>
    </message>
    <message>
        <source>Copied a methods paragraph on this mesh.</source>
        <translation>Bu ağ için bir yöntem paragrafı (İngilizce) kopyalandı.</translation>
    </message>
    <message>
        <source>Copied a methods paragraph on a mesh of earlier parameters: run again for the present ones.</source>
        <translation>Kopyalanan yöntem paragrafı önceki parametrelerin ağına ait: şimdikiler için yeniden çalıştırın.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ResultModel</name>
    <message>
        <source>tick a part on</source>
        <translation>parçayı işaretleme</translation>
    </message>
    <message>
        <source>tick a part off</source>
        <translation>parçanın işaretini kaldırma</translation>
    </message>
    <message>
        <source>keep only one part</source>
        <translation>yalnız bir parçayı tutma</translation>
    </message>
    <message>
        <source>Such a surface is not begun: %1.</source>
        <translation>Böyle bir yüzeye başlanmaz: %1.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ReviewPanel</name>
    <message>
        <source>Hole</source>
        <translation>Delik</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Boyun</translation>
    </message>
    <message>
        <source>Missed?</source>
        <translation>Eksik mi?</translation>
    </message>
    <message>
        <source>Island</source>
        <translation>Ada</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Kabul et</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Reddet</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puan</translation>
    </message>
    <message>
        <source>Of the whole segmentation, from 1, worst, to 5, best</source>
        <translation>Tüm bölütlemenin, 1 (en kötü) ile 5 (en iyi) arası</translation>
    </message>
    <message>
        <source>Given to an earlier result</source>
        <translation>Önceki bir sonuca verildi</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Bul</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Önceki</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Sonraki</translation>
    </message>
    <message>
        <source>Looks for small holes, necks, high vesselness outside, and small parts that hang on nothing</source>
        <translation>Küçük delikleri, boyunları, dışarıdaki yüksek damarsılığı ve hiçbir şeye bağlı olmayan küçük parçaları arar</translation>
    </message>
    <message>
        <source>Doubt</source>
        <translation>Şüphe</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Neden</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Notlar</translation>
    </message>
    <message>
        <source>Add at the crosshair</source>
        <translation>Artı imlece ekle</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Kaldır</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Yer</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Not</translation>
    </message>
    <message>
        <source>Doubtful places</source>
        <translation>Şüpheli yerler</translation>
    </message>
    <message>
        <source>Looking for doubtful places…</source>
        <translation>Şüpheli yerler aranıyor…</translation>
    </message>
    <message>
        <source>%1 of %2 doubtful places seen</source>
        <translation>Bakılan şüpheli yer: %1 / %2</translation>
    </message>
    <message>
        <source>Of the vessel there, from 1, worst, to 5, best</source>
        <translation>Oradaki damarın, 1 (en kötü) ile 5 (en iyi) arası</translation>
    </message>
</context>
<context>
    <name>angiomesh::RunModel</name>
    <message>
        <source>converged</source>
        <translation>yakınsadı</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>duruldu</translation>
    </message>
    <message>
        <source>not converged at the limit</source>
        <translation>sınırda yakınsamadı</translation>
    </message>
    <message>
        <source>finished by hand (a next run evolves again)</source>
        <translation>elle bitirildi (sonraki çalıştırma evrimi yineler)</translation>
    </message>
    <message>
        <source>ended as asked</source>
        <translation>istendiği gibi bitti</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 başarısız: %2</translation>
    </message>
    <message>
        <source>Evolve: label %1, %2 voxels, moved by at most %3 voxel.</source>
        <translation>Evrim: etiket %1, %2 voksel, en çok %3 voksel kaydırıldı.</translation>
    </message>
    <message>
        <source>Evolve: %1 after %2 iterations, threshold b = %3.</source>
        <translation>Evrim: %2 yinelemeden sonra %1, eşik b = %3.</translation>
    </message>
    <message>
        <source>Evolve: segmented by another method than the level set.</source>
        <translation>Evrim: düzey kümesinden başka bir yöntemle bölütlendi.</translation>
    </message>
    <message>
        <source>Cancelled in step %1.</source>
        <translation>İptal edildi, adım: %1.</translation>
    </message>
    <message>
        <source>Done up to %1</source>
        <translation>Bitti, son adım: %1</translation>
    </message>
    <message>
        <source>, %1 triangles, %2 s</source>
        <translation>, %1 üçgen, %2 sn</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeedList</name>
    <message>
        <source>Remove seed</source>
        <translation>Tohumu kaldır</translation>
    </message>
    <message>
        <source>%1 seeds in use</source>
        <translation>%1 tohum kullanımda</translation>
    </message>
    <message>
        <source>No seeds yet</source>
        <translation>Henüz tohum yok</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeedMenu</name>
    <message>
        <source>Seeds</source>
        <translation>Tohumlar</translation>
    </message>
    <message>
        <source>Put a seed here</source>
        <translation>Buraya bir tohum koy</translation>
    </message>
    <message>
        <source>Remove this seed</source>
        <translation>Bu tohumu kaldır</translation>
    </message>
    <message>
        <source>This vessel only</source>
        <translation>Yalnızca bu damar</translation>
    </message>
    <message>
        <source>The only seed is here, and parts without a seed are left out</source>
        <translation>Tek tohum buradadır ve tohumsuz parçalar dışarıda bırakılır</translation>
    </message>
</context>
<context>
    <name>angiomesh::SensitivityPanel</name>
    <message>
        <source>Try the parameters</source>
        <translation>Parametreleri dene</translation>
    </message>
    <message>
        <source>Runs the segmentation in the background with each main parameter a step up and a step down. The case stays as it is.</source>
        <translation>Segmentasyonu arka planda her ana parametre bir adım yukarı ve bir adım aşağı olacak şekilde çalıştırır. Vaka olduğu gibi kalır.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Paint the wall</source>
        <translation>Duvarı boya</translation>
    </message>
    <message>
        <source>Shows in 3D, in place of the mesh, the wall with its moves in colour</source>
        <translation>3B&apos;de ağın yerine duvarı, kaymaları renkli olarak gösterir</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Adım</translation>
    </message>
    <message>
        <source>Mean, mm</source>
        <translation>Ortalama, mm</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>Yüzde 95</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Kayıp</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Hacim</translation>
    </message>
    <message>
        <source>The parameter, its value, and the value that was tried</source>
        <translation>Parametre, değeri ve denenen değer</translation>
    </message>
    <message>
        <source>Mean move of the wall, outwards positive, without what is lost</source>
        <translation>Duvarın ortalama kayması, dışa doğru pozitif, kaybolan hariç</translation>
    </message>
    <message>
        <source>95 % of the wall move less than this either way, mm</source>
        <translation>Duvarın yüzde 95&apos;i iki yönde de bundan az kayar, mm</translation>
    </message>
    <message>
        <source>Part of the wall whose vessel is gone</source>
        <translation>Damarı kaybolan duvar bölümü</translation>
    </message>
    <message>
        <source>By how much the vessels have more volume</source>
        <translation>Damar hacminin ne kadar arttığı</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>No.</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Uzunluk, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Yarıçap, mm</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Değişim</translation>
    </message>
    <message>
        <source>The longest first; a click takes the panes there</source>
        <translation>En uzunu önce; tıklama görünümleri oraya götürür</translation>
    </message>
    <message>
        <source>Of its centre line</source>
        <translation>Merkez çizgisinin</translation>
    </message>
    <message>
        <source>Mean radius</source>
        <translation>Ortalama yarıçap</translation>
    </message>
    <message>
        <source>By how much the mean radius is larger after the step, mm; with all steps the largest change</source>
        <translation>Adımdan sonra ortalama yarıçapın ne kadar büyüdüğü, mm; tüm adımlarda en büyük değişim</translation>
    </message>
    <message>
        <source>Part of its wall that is lost; with all steps the largest part</source>
        <translation>Duvarının kaybolan bölümü; tüm adımlarda en büyüğü</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Deneniyor…</translation>
    </message>
    <message>
        <source>By how much does the wall move when a parameter does?</source>
        <translation>Bir parametre değişince duvar ne kadar kayar?</translation>
    </message>
    <message>
        <source>Of earlier parameters: try again for the present ones.</source>
        <translation>Önceki parametrelere ait: şimdikiler için yeniden deneyin.</translation>
    </message>
    <message>
        <source>%1 steps in %2</source>
        <translation>%2 içinde %1 adım</translation>
    </message>
    <message>
        <source>All: largest move</source>
        <translation>Tümü: en büyük kayma</translation>
    </message>
    <message>
        <source>none</source>
        <translation>yok</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeriesDialog</name>
    <message>
        <source>ready</source>
        <translation>hazır</translation>
    </message>
    <message>
        <source>uneven slices</source>
        <translation>eşitsiz aralık</translation>
    </message>
    <message>
        <source>no volume</source>
        <translation>hacim yok</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Seri seç</translation>
    </message>
    <message>
        <source>%1 volumes were found.</source>
        <translation>%1 hacim bulundu.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Açıklama</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalite</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Boyut</translation>
    </message>
    <message>
        <source>Spacing, mm</source>
        <translation>Aralık, mm</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Yönelim</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>No.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Tarih</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Durum</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Aç</translation>
    </message>
</context>
<context>
    <name>angiomesh::SliceView</name>
    <message>
        <source>%1, voxel %2,%3,%4</source>
        <translation>%1, voksel %2,%3,%4</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Aksiyel</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Ortalama</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>%1° döndürülmüş</translation>
    </message>
    <message>
        <source>Patient axes</source>
        <translation>Hasta eksenleri</translation>
    </message>
</context>
<context>
    <name>angiomesh::StepPanel</name>
    <message>
        <source>Run to here</source>
        <translation>Buraya kadar</translation>
    </message>
    <message>
        <source>Runs the pipeline up to this step</source>
        <translation>İşlem hattını bu adıma kadar çalıştırır</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Daha çok</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Daha az</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>yapılmadı</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>gerekmiyor</translation>
    </message>
    <message>
        <source>fresh</source>
        <translation>güncel</translation>
    </message>
    <message>
        <source>fresh, %1 s</source>
        <translation>güncel, %1 sn</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>duraklatıldı</translation>
    </message>
    <message>
        <source>running</source>
        <translation>çalışıyor</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>eskimiş</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>başarısız</translation>
    </message>
    <message>
        <source>More (changed: %1)</source>
        <translation>Daha fazla (değiştirilen: %1)</translation>
    </message>
</context>
<context>
    <name>angiomesh::SurfaceNote</name>
    <message>
        <source>%1 triangles</source>
        <translation>%1 üçgen</translation>
    </message>
    <message>
        <source>%1 expected</source>
        <translation>beklenen: %1</translation>
    </message>
    <message>
        <source>about %1 triangles</source>
        <translation>yaklaşık %1 üçgen</translation>
    </message>
    <message>
        <source>%1 % from the front</source>
        <translation>cepheden %1 %</translation>
    </message>
    <message>
        <source>%1 components verified</source>
        <translation>doğrulanan bileşen: %1</translation>
    </message>
    <message>
        <source>Not fit for a solver: %1</source>
        <translation>Çözücüye uygun değil: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::SurfacePane</name>
    <message>
        <source>Moves of the wall, out of date</source>
        <translation>Duvarın kaymaları, güncel değil</translation>
    </message>
    <message>
        <source>Moves of the wall</source>
        <translation>Duvarın kaymaları</translation>
    </message>
</context>
<context>
    <name>angiomesh::ViewButtons</name>
    <message>
        <source>From the front (A)</source>
        <translation>Önden (A)</translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation>Arkadan (P)</translation>
    </message>
    <message>
        <source>From the patient&apos;s left (L)</source>
        <translation>Hastanın solundan (L)</translation>
    </message>
    <message>
        <source>From the patient&apos;s right (Shift+R)</source>
        <translation>Hastanın sağından (Shift+R)</translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation>Baştan (S)</translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation>Ayaktan (I)</translation>
    </message>
</context>
<context>
    <name>angiomesh::ViewGrid</name>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>aksiyel</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>koronal</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>sagital</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HU</translation>
    </message>
    <message>
        <source>MIP: %1</source>
        <translation>MIP: %1</translation>
    </message>
    <message>
        <source>Slices: %1</source>
        <translation>Kesitler: %1</translation>
    </message>
    <message>
        <source>Some parts hidden</source>
        <translation>Bazı parçalar gizli</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <translation>Hacim: %1</translation>
    </message>
    <message>
        <source>3D, result</source>
        <translation>3D, sonuç</translation>
    </message>
    <message>
        <source>MIP: result</source>
        <translation>MIP: sonuç</translation>
    </message>
    <message>
        <source>3D, beside</source>
        <translation>3B, yanındaki</translation>
    </message>
    <message>
        <source>Preview in the box</source>
        <translation>Kutudaki önizleme</translation>
    </message>
</context>
<context>
    <name>angiomesh::ViewTools</name>
    <message>
        <source>Two by two</source>
        <translation>İkiye iki</translation>
    </message>
    <message>
        <source>One large, three small</source>
        <translation>Biri büyük, üçü küçük</translation>
    </message>
    <message>
        <source>One alone</source>
        <translation>Tek bölme</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>A&amp;raçlar</translation>
    </message>
    <message>
        <source>Navigate</source>
        <translation>Gezin</translation>
    </message>
    <message>
        <source>Pick seed</source>
        <translation>Tohum seç</translation>
    </message>
    <message>
        <source>Draw ROI</source>
        <translation>ROI çiz</translation>
    </message>
    <message>
        <source>Cut vessel</source>
        <translation>Damarı kes</translation>
    </message>
    <message>
        <source>Left button moves the crosshair (Engineering)</source>
        <translation>Sol tuş artı imleci taşır (Mühendislik)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturlar</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Yüzey</translation>
    </message>
    <message>
        <source>Ctrl+U</source>
        <translation>Ctrl+U</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kenarlar</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Interpolate slices</source>
        <translation>Kesitleri enterpole et</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Reset all panes</source>
        <translation>Tüm bölmeleri sıfırla</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Show the log</source>
        <translation>Günlüğü göster</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Only axial</source>
        <translation>Yalnız aksiyel</translation>
    </message>
    <message>
        <source>Only sagittal</source>
        <translation>Yalnız sagital</translation>
    </message>
    <message>
        <source>Only coronal</source>
        <translation>Yalnız koronal</translation>
    </message>
    <message>
        <source>Only 3D</source>
        <translation>Yalnız 3D</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Yerleşim</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Sistemdeki gibi</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Açık</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Koyu</translation>
    </message>
    <message>
        <source>Language, from the next start</source>
        <translation>Dil, sonraki açılıştan itibaren</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Çalışma</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Bölmeler</translation>
    </message>
    <message>
        <source> Layer </source>
        <translation> Katman </translation>
    </message>
    <message>
        <source>  Slab </source>
        <translation>  Dilim </translation>
    </message>
    <message>
        <source>off</source>
        <translation>kapalı</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>ortalama</translation>
    </message>
    <message>
        <source>by pane</source>
        <translation>farklı</translation>
    </message>
    <message>
        <source>Of all slice panes. The right-click menu of a pane, M and Alt with the wheel change one of them.</source>
        <translation>Tüm kesit bölmelerinin. Bir bölmenin sağ tık menüsü, M tuşu ve Alt ile tekerlek yalnız birini değiştirir.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>angiomesh::VolumeMenu</name>
    <message>
        <source>Volume in 3D</source>
        <translation>3D hacim</translation>
    </message>
    <message>
        <source>Result beside the image</source>
        <translation>Sonuç görüntünün yanında</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>3D MIP</source>
        <translation>3D MIP</translation>
    </message>
    <message>
        <source>Shaded, MR angiography</source>
        <translation>Gölgeli, MR anjiyografi</translation>
    </message>
    <message>
        <source>Shaded, CT angiography</source>
        <translation>Gölgeli, BT anjiyografi</translation>
    </message>
</context>
<context>
    <name>angiomesh::WelcomePage</name>
    <message>
        <source>Open again</source>
        <translation>Yeniden aç</translation>
    </message>
    <message>
        <source>From an angiogram (MRA or CTA) to a vessel surface that a flow solver accepts.</source>
        <translation>Anjiyogramdan (MRA veya BTA) akış çözücünün kabul ettiği damar yüzeyine.</translation>
    </message>
    <message>
        <source>Or drop a file, a folder or a case anywhere on this window.</source>
        <translation>Ya da bu pencerenin herhangi bir yerine bir dosya, klasör veya vaka bırakın.</translation>
    </message>
    <message>
        <source>Not a medical device: research use only.</source>
        <translation>Tıbbi cihaz değildir: yalnız araştırma amaçlıdır.</translation>
    </message>
</context>
<context>
    <name>angiomesh::WhyPanel</name>
    <message>
        <source>Place</source>
        <translation>Yer</translation>
    </message>
    <message>
        <source>The voxel of the grid that the method works on, and where it lies</source>
        <translation>Yöntemin çalıştığı ızgaranın vokseli ve bulunduğu yer</translation>
    </message>
    <message>
        <source>Distance to the wall</source>
        <translation>Duvara uzaklık</translation>
    </message>
    <message>
        <source>Negative inside</source>
        <translation>İçeride negatif</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Parlaklık</translation>
    </message>
    <message>
        <source>Of the preprocessed image, and how far that is on the way from the surroundings to the lumen nearby</source>
        <translation>Ön işlenmiş görüntünün; ve bunun yakındaki çevreden lümene giden yolda nerede olduğu</translation>
    </message>
    <message>
        <source>Vesselness v</source>
        <translation>Damarsılık v</translation>
    </message>
    <message>
        <source>The value of largest magnitude over all scales, and the thresholds that it is compared with</source>
        <translation>Tüm ölçeklerde büyüklüğü en yüksek değer ve karşılaştırıldığı eşikler</translation>
    </message>
    <message>
        <source>Best scale</source>
        <translation>En iyi ölçek</translation>
    </message>
    <message>
        <source>The scale at which that value was found, of those searched</source>
        <translation>Aranan ölçekler içinde bu değerin bulunduğu ölçek</translation>
    </message>
    <message>
        <source>Eigenvalues</source>
        <translation>Özdeğerler</translation>
    </message>
    <message>
        <source>Of the Hessian times σ² at that scale: in a bright vessel the first is near 0, and both others are negative and alike</source>
        <translation>O ölçekte σ² ile çarpılan Hessian matrisinin: parlak bir damarda ilki 0&apos;a yakındır, öteki ikisi negatif ve birbirine yakındır</translation>
    </message>
    <message>
        <source>Speed p</source>
        <translation>Hız p</translation>
    </message>
    <message>
        <source>1 pulls the front outwards, −1 inwards</source>
        <translation>1 cepheyi dışa, −1 içe çeker</translation>
    </message>
    <message>
        <source>Curvature term</source>
        <translation>Eğrilik terimi</translation>
    </message>
    <message>
        <source>(1 − γ) |d κ|: pushes the front on at thin vessels</source>
        <translation>(1 − γ) |d κ|: cepheyi ince damarlarda ileri iter</translation>
    </message>
    <message>
        <source>Speed F</source>
        <translation>Hız F</translation>
    </message>
    <message>
        <source>γ p + (1 − γ) |d κ|: the front moves outwards where it is positive</source>
        <translation>γ p + (1 − γ) |d κ|: pozitif olduğu yerde cephe dışa ilerler</translation>
    </message>
    <message>
        <source>Run to Evolve, by the level set, to see why the voxel under the crosshair is vessel or not.</source>
        <translation>Artı imlecin altındaki vokselin neden damar olduğunu ya da olmadığını görmek için düzey kümesiyle Evrim adımına kadar çalıştırın.</translation>
    </message>
    <message>
        <source>Open a volume first.</source>
        <translation>Önce bir hacim açın.</translation>
    </message>
    <message>
        <source>voxel %1,%2,%3, %4</source>
        <translation>voksel %1,%2,%3, %4</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>, %1 of the way from %2 to %3</source>
        <translation>, %2 – %3 arasında %1</translation>
    </message>
    <message>
        <source>%1 (b = %2, a = %3)</source>
        <translation>%1 (b = %2, a = %3)</translation>
    </message>
    <message>
        <source>σ = %1 mm of %2 to %3 mm</source>
        <translation>σ = %1 mm (%2 – %3 mm içinden)</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 (κ = %2 per voxel)</source>
        <translation>%1 (κ = voksel başına %2)</translation>
    </message>
</context>
<context>
    <name>angiomesh::WindowMenu</name>
    <message>
        <source>Window</source>
        <translation>Pencere</translation>
    </message>
    <message>
        <source>Window: %1</source>
        <translation>Pencere: %1</translation>
    </message>
    <message>
        <source>Other windows of the file</source>
        <translation>Dosyanın öteki pencereleri</translation>
    </message>
    <message>
        <source>Set window and level…</source>
        <translation>Pencere ve seviye ayarla…</translation>
    </message>
    <message>
        <source>Reset window and level</source>
        <translation>Pencere ve seviyeyi sıfırla</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Window and level</source>
        <translation>Pencere ve seviye</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Seviye</translation>
    </message>
</context>
<context>
    <name>angiomesh::Workspaces</name>
    <message>
        <source>Review</source>
        <translation>İnceleme</translation>
    </message>
    <message>
        <source>The images, with nothing beside them</source>
        <translation>Görüntüler, yanlarında başka bir şey olmadan</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Ayar</translation>
    </message>
    <message>
        <source>The steps of the pipeline and the convergence</source>
        <translation>İşlem hattının adımları ve yakınsama</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Ağ</translation>
    </message>
    <message>
        <source>The mesh inspector, the ports and the log</source>
        <translation>Ağ denetimi, açıklıklar ve günlük</translation>
    </message>
    <message>
        <source>Reset this workspace</source>
        <translation>Bu çalışma alanını sıfırla</translation>
    </message>
</context>
<context>
    <name>angiomesh::WorstList</name>
    <message>
        <source>Choose a row to go there in 3D and in the slices; the arrow keys go on.</source>
        <translation>3D&apos;de ve kesitlerde oraya gitmek için bir satır seçin; ok tuşlarıyla ilerleyin.</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Değer</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Yer</translation>
    </message>
</context>
</TS>
