<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CasePorts</name>
    <message>
        <source>left out of the surface with the part that it ends</source>
        <translation>mit dem Teil, den er abschließt, aus der Oberfläche weggelassen</translation>
    </message>
    <message>
        <source>made</source>
        <translation>ausgeführt</translation>
    </message>
    <message>
        <source>run to make it</source>
        <translation>rechnen, um ihn auszuführen</translation>
    </message>
    <message>
        <source>at the volume&apos;s border</source>
        <translation>am Volumenrand</translation>
    </message>
    <message>
        <source>cut automatically</source>
        <translation>automatisch geschnitten</translation>
    </message>
    <message>
        <source>slices its vessel: %1° off its axis, %2 times its section; Cut across ends it just inside</source>
        <translation>schneidet ihr Gefäß schräg an: %1° zur Achse, %2-facher Querschnitt; Quer schneiden beendet es knapp innerhalb</translation>
    </message>
    <message>
        <source>being looked at</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>run to Evolve to see where it lies</source>
        <translation>bis Evolution rechnen, um zu sehen, wo er liegt</translation>
    </message>
    <message>
        <source>, in the last mesh</source>
        <translation>, im letzten Netz</translation>
    </message>
</context>
<context>
    <name>MeshFormat</name>
    <message>
        <source>STL keeps no topology: each triangle stands by itself, and its points have to be merged again on import.</source>
        <translation>STL speichert keine Topologie: Jedes Dreieck steht für sich, und seine Punkte müssen beim Import wieder verschmolzen werden.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>1/eta of eq. 4.2: the wanted edge length grows by at most 1 - 1/eta per length</source>
        <translation>1/eta aus Gl. 4.2: die Soll-Kantenlänge wächst um höchstens 1 - 1/eta je Länge</translation>
    </message>
    <message>
        <source>Accuracy from ρ only</source>
        <translation>Genauigkeit nur aus ρ</translation>
    </message>
    <message>
        <source>Accuracy ρ</source>
        <translation>Genauigkeit ρ</translation>
    </message>
    <message>
        <source>At the border</source>
        <translation>Am Rand</translation>
    </message>
    <message>
        <source>Automatic seeds</source>
        <translation>Auto-Saatpunkte</translation>
    </message>
    <message>
        <source>Best voxels taken</source>
        <translation>Beste Voxel</translation>
    </message>
    <message>
        <source>Bone above</source>
        <translation>Knochen ab</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Check every</source>
        <translation>Prüfabstand</translation>
    </message>
    <message>
        <source>Contour: RMS change</source>
        <translation>Kontur: RMS-Änderung</translation>
    </message>
    <message>
        <source>Contour: advection</source>
        <translation>Kontur: Advektion</translation>
    </message>
    <message>
        <source>Contour: curvature</source>
        <translation>Kontur: Krümmung</translation>
    </message>
    <message>
        <source>Contour: iterations</source>
        <translation>Kontur: Iterationen</translation>
    </message>
    <message>
        <source>Contour: propagation</source>
        <translation>Kontur: Ausbreitung</translation>
    </message>
    <message>
        <source>Contour: scale</source>
        <translation>Kontur: Skala</translation>
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
        <translation>Kontrast aus</translation>
    </message>
    <message>
        <source>Cubic voxels</source>
        <translation>Kubische Voxel</translation>
    </message>
    <message>
        <source>Cut across at the border</source>
        <translation>Am Rand quer schneiden</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Edges around</source>
        <translation>Kanten um ein Gefäß</translation>
    </message>
    <message>
        <source>Ends cut at</source>
        <translation>Endschnitt bei</translation>
    </message>
    <message>
        <source>Even sizes 1/η</source>
        <translation>Gleichmaß 1/η</translation>
    </message>
    <message>
        <source>Finest edge</source>
        <translation>Feinste Kante</translation>
    </message>
    <message>
        <source>Follow image γ</source>
        <translation>Bildtreue γ</translation>
    </message>
    <message>
        <source>Grow back by μ</source>
        <translation>Rückwachsen um μ</translation>
    </message>
    <message>
        <source>Interpolant</source>
        <translation>Interpolante</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Keep apart up to k</source>
        <translation>Trennen bis k</translation>
    </message>
    <message>
        <source>Keep blobs β</source>
        <translation>Blobs erhalten β</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Largest b</source>
        <translation>Größtes b</translation>
    </message>
    <message>
        <source>Least b</source>
        <translation>Kleinstes b</translation>
    </message>
    <message>
        <source>Lumen limit</source>
        <translation>Lumengrenze</translation>
    </message>
    <message>
        <source>Least component</source>
        <translation>Kleinste Komponente</translation>
    </message>
    <message>
        <source>Least length</source>
        <translation>Mindestlänge</translation>
    </message>
    <message>
        <source>Least part without a seed</source>
        <translation>Kleinster Teil ohne Saatpunkt</translation>
    </message>
    <message>
        <source>Least vesselness</source>
        <translation>Min. Vesselness</translation>
    </message>
    <message>
        <source>Least vesselness b</source>
        <translation>Min. Vesselness b</translation>
    </message>
    <message>
        <source>Least volume</source>
        <translation>Mindestvolumen</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Lowest intensity</source>
        <translation>Min. Intensität</translation>
    </message>
    <message>
        <source>Lumen mean, steps</source>
        <translation>Lumenmittel, Schritte</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Stretch, middle</source>
        <translation>Spreizung, Mitte</translation>
    </message>
    <message>
        <source>Most iterations</source>
        <translation>Max. Iterationen</translation>
    </message>
    <message>
        <source>Most triangles</source>
        <translation>Max. Dreiecke</translation>
    </message>
    <message>
        <source>Names of ports</source>
        <translation>Öffnungsnamen</translation>
    </message>
    <message>
        <source>Noise removal per step</source>
        <translation>Entrauschen je Schritt</translation>
    </message>
    <message>
        <source>Noise removal, steps</source>
        <translation>Entrauschen, Schritte</translation>
    </message>
    <message>
        <source>Parts kept</source>
        <translation>Teile im Netz</translation>
    </message>
    <message>
        <source>Parts ticked off</source>
        <translation>Abgewählte Teile</translation>
    </message>
    <message>
        <source>Pass one-voxel vessels</source>
        <translation>Durch 1-Voxel-Gefäße</translation>
    </message>
    <message>
        <source>Point spread</source>
        <translation>Unschärfe (PSF)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Thin vessels d</source>
        <translation>Dünne Gefäße d</translation>
    </message>
    <message>
        <source>Reach of the wall</source>
        <translation>Suchweite der Wand</translation>
    </message>
    <message>
        <source>Region of interest</source>
        <translation>Bereich (ROI)</translation>
    </message>
    <message>
        <source>Region: iterations</source>
        <translation>Region: Iterationen</translation>
    </message>
    <message>
        <source>Region: multiplier</source>
        <translation>Region: Faktor</translation>
    </message>
    <message>
        <source>Region: radius</source>
        <translation>Region: Radius</translation>
    </message>
    <message>
        <source>Reject noise c</source>
        <translation>Rauschgrenze c</translation>
    </message>
    <message>
        <source>Reject noise, share of contrast</source>
        <translation>Rauschgrenze, Anteil am Kontrast</translation>
    </message>
    <message>
        <source>Reject plates α</source>
        <translation>Platten abweisen α</translation>
    </message>
    <message>
        <source>Relax bends</source>
        <translation>Bögen lockern</translation>
    </message>
    <message>
        <source>Remove noise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Rim of bone</source>
        <translation>Knochensaum</translation>
    </message>
    <message>
        <source>Seeds by hand</source>
        <translation>Eigene Saatpunkte</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>Kürzeste Kante</translation>
    </message>
    <message>
        <source>Sizes from the image</source>
        <translation>Größen aus dem Bild</translation>
    </message>
    <message>
        <source>Sizes looked for</source>
        <translation>Gesuchte Größen</translation>
    </message>
    <message>
        <source>Smooth by λ</source>
        <translation>Glätten um λ</translation>
    </message>
    <message>
        <source>Smooth wall</source>
        <translation>Glatte Wand</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Smoothing across</source>
        <translation>Glättung quer</translation>
    </message>
    <message>
        <source>Smoothing along</source>
        <translation>Glättung längs</translation>
    </message>
    <message>
        <source>Smoothness of the wall</source>
        <translation>Glätte der Wand</translation>
    </message>
    <message>
        <source>Spacing of the sizes</source>
        <translation>Abstand der Größen</translation>
    </message>
    <message>
        <source>Specificity ξ</source>
        <translation>Spezifität ξ</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Start aus</translation>
    </message>
    <message>
        <source>Stay near the wall</source>
        <translation>Nahe der Wand</translation>
    </message>
    <message>
        <source>Step of the front</source>
        <translation>Schritt der Front</translation>
    </message>
    <message>
        <source>Stop after</source>
        <translation>Stopp nach</translation>
    </message>
    <message>
        <source>Stretch the vessels&apos; greys</source>
        <translation>Grauwerte der Gefäße spreizen</translation>
    </message>
    <message>
        <source>Thickest vessel</source>
        <translation>Dickstes Gefäß</translation>
    </message>
    <message>
        <source>Thinnest vessel</source>
        <translation>Dünnstes Gefäß</translation>
    </message>
    <message>
        <source>Threshold: Gaussian</source>
        <translation>Schwelle: Gauß</translation>
    </message>
    <message>
        <source>Threshold: from the seeds</source>
        <translation>Schwelle: ab Saatpunkten</translation>
    </message>
    <message>
        <source>Threshold: lower</source>
        <translation>Schwelle: untere</translation>
    </message>
    <message>
        <source>Threshold: upper</source>
        <translation>Schwelle: obere</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tolerance, delta</source>
        <translation>Toleranz, delta</translation>
    </message>
    <message>
        <source>Vesselness measure</source>
        <translation>Vesselness-Maß</translation>
    </message>
    <message>
        <source>Vessels are</source>
        <translation>Gefäße sind</translation>
    </message>
    <message>
        <source>Voxels joined by</source>
        <translation>Voxel verbunden über</translation>
    </message>
    <message>
        <source>Wall from the image</source>
        <translation>Wand aus dem Bild</translation>
    </message>
    <message>
        <source>Stretch, width</source>
        <translation>Spreizung, Breite</translation>
    </message>
    <message>
        <source>a contour that has not come to rest goes on</source>
        <translation>eine Kontur, die noch nicht ruht, läuft weiter</translation>
    </message>
    <message>
        <source>a front that has not come to rest goes on</source>
        <translation>eine Front, die noch nicht ruht, läuft weiter</translation>
    </message>
    <message>
        <source>accuracy: the angle that an edge subtends on the osculating circle, eq. 4.1, down to edgeMinVoxels</source>
        <translation>Genauigkeit: der Winkel, den eine Kante auf dem Krümmungskreis überspannt, Gl. 4.1, bis hinab zu edgeMinVoxels</translation>
    </message>
    <message>
        <source>advancing-front: triangles of the wanted size, made on phi = 0 itself; marching-cubes: the triangles of each cell; remesh: marching cubes, remeshed to the wanted size</source>
        <translation>advancing-front: Dreiecke der gewünschten Größe, direkt auf phi = 0 erzeugt; marching-cubes: die Dreiecke jeder Zelle; remesh: Marching Cubes, auf die gewünschte Größe neu vernetzt</translation>
    </message>
    <message>
        <source>also move the front in vessels and gaps one voxel wide, where upwind differences vanish</source>
        <translation>die Front auch in Gefäßen und Lücken von einem Voxel Breite bewegen, wo Upwind-Differenzen verschwinden</translation>
    </message>
    <message>
        <source>b from</source>
        <translation>b aus</translation>
    </message>
    <message>
        <source>blobs, branchings and aneurysms get more</source>
        <translation>Blobs, Verzweigungen und Aneurysmen erhalten mehr</translation>
    </message>
    <message>
        <source>bone&apos;s blurred edge goes, and vessels that touch it get thinner</source>
        <translation>der unscharfe Rand der Knochen verschwindet, und Gefäße, die daran liegen, werden dünner</translation>
    </message>
    <message>
        <source>brighter voxels count as bone, calcium or metal; they and a rim around them are filled with the median intensity between the bounds; none: no upper bound</source>
        <translation>hellere Voxel gelten als Knochen, Kalk oder Metall; sie und ein Saum um sie werden mit der mittleren Intensität (Median) zwischen den Grenzen gefüllt; none: keine obere Grenze</translation>
    </message>
    <message>
        <source>c as a fraction of the contrast</source>
        <translation>c als Bruchteil des Kontrasts</translation>
    </message>
    <message>
        <source>centre of the sigmoid, as the viewer&apos;s level; auto: middle of the percentiles</source>
        <translation>Mitte des Sigmoids, wie die Mitte des Fensters der Anzeige; auto: Mitte der Perzentile</translation>
    </message>
    <message>
        <source>components smaller than this are left out</source>
        <translation>kleinere Komponenten werden weggelassen</translation>
    </message>
    <message>
        <source>components with centre lines shorter than this, all branches together, are left out; so is what is not longer than it is thick</source>
        <translation>Komponenten mit kürzeren Mittellinien, alle Äste zusammen, werden weggelassen; ebenso, was nicht länger als dick ist</translation>
    </message>
    <message>
        <source>contrast: b = 0.007 xi; average: eq. 3.20, clamped to bMin..bMax</source>
        <translation>contrast: b = 0,007 xi; average: Gl. 3.20, begrenzt auf bMin..bMax</translation>
    </message>
    <message>
        <source>converged below this change per inside voxel between checks</source>
        <translation>konvergiert, wenn die Änderung je innerem Voxel zwischen zwei Prüfungen kleiner ist</translation>
    </message>
    <message>
        <source>converged only if the change also differs from the previous one by less than this</source>
        <translation>konvergiert nur, wenn sich die Änderung auch von der vorigen um weniger unterscheidet</translation>
    </message>
    <message>
        <source>curvature asks for no shorter edge than this, in edges of a cube as large as a voxel; none: no limit</source>
        <translation>die Krümmung verlangt keine kürzere Kante als diese, in Kanten eines Würfels von der Größe eines Voxels; none: keine Grenze</translation>
    </message>
    <message>
        <source>cut every vessel that ends inside the volume this many radii before its tip, as end_1, end_2, ...; 0: off</source>
        <translation>jedes Gefäß, das im Volumen endet, so viele Radien vor seiner Spitze schneiden, als end_1, end_2, ...; 0: aus</translation>
    </message>
    <message>
        <source>cut vessels that the border slices (by more than 30 degrees, or 1.3 times their section) straight across just inside, as across_1, across_2, ...</source>
        <translation>Gefäße, die der Rand schräg anschneidet (um mehr als 30 Grad oder das 1,3-fache ihres Querschnitts), knapp innerhalb quer schneiden, als across_1, across_2, ...</translation>
    </message>
    <message>
        <source>do not start a surface expected to have more triangles than this; 0: no limit; auto: what fits this machine&apos;s memory and about half an hour</source>
        <translation>keine Oberfläche beginnen, für die mehr Dreiecke zu erwarten sind; 0: keine Grenze; auto: was in den Speicher dieses Rechners und in etwa eine halbe Stunde passt</translation>
    </message>
    <message>
        <source>each iteration smooths more</source>
        <translation>jede Iteration glättet stärker</translation>
    </message>
    <message>
        <source>edge of a marching cubes cell, working voxels</source>
        <translation>Kante einer Marching-Cubes-Zelle, Arbeitsvoxel</translation>
    </message>
    <message>
        <source>end the evolution after this many iterations and take the front as it stands; none: it ends by itself</source>
        <translation>die Evolution nach so vielen Iterationen beenden und die Front nehmen, wie sie ist; none: sie endet von selbst</translation>
    </message>
    <message>
        <source>faint vessels and noise get less</source>
        <translation>schwache Gefäße und Rauschen erhalten weniger</translation>
    </message>
    <message>
        <source>faint vessels are left out</source>
        <translation>schwache Gefäße fallen weg</translation>
    </message>
    <message>
        <source>faint vessels get darker</source>
        <translation>schwache Gefäße werden dunkler</translation>
    </message>
    <message>
        <source>faint vessels get no seeds of their own</source>
        <translation>schwache Gefäße erhalten keine eigenen Saatpunkte</translation>
    </message>
    <message>
        <source>fainter vessels get seeds, and so may what is none</source>
        <translation>schwächere Gefäße erhalten Saatpunkte, vielleicht aber auch, was keines ist</translation>
    </message>
    <message>
        <source>fewer and larger triangles</source>
        <translation>weniger und größere Dreiecke</translation>
    </message>
    <message>
        <source>fewer and larger triangles, which follow the wall less closely</source>
        <translation>weniger und größere Dreiecke, die der Wand weniger genau folgen</translation>
    </message>
    <message>
        <source>fewer triangles on wide vessels</source>
        <translation>weniger Dreiecke auf weiten Gefäßen</translation>
    </message>
    <message>
        <source>fewer triangles where the wall is most curved</source>
        <translation>weniger Dreiecke, wo die Wand am stärksten gekrümmt ist</translation>
    </message>
    <message>
        <source>fewer triangles, and thin vessels get angular</source>
        <translation>weniger Dreiecke, und dünne Gefäße werden kantig</translation>
    </message>
    <message>
        <source>find seeds by vesselness</source>
        <translation>Saatpunkte anhand der Vesselness finden</translation>
    </message>
    <message>
        <source>flood: start from everything with v &gt;= b that is connected to a seed; seeds: grow from the seeds</source>
        <translation>flood: Start aus allem mit v &gt;= b, was mit einem Saatpunkt verbunden ist; seeds: aus den Saatpunkten wachsen</translation>
    </message>
    <message>
        <source>gradient magnitude, intensities per working voxel, at which the contour has half its speed; auto: from the image&apos;s contrast and noise</source>
        <translation>Betrag des Gradienten, Intensität je Arbeitsvoxel, bei dem die Kontur halb so schnell ist; auto: aus Kontrast und Rauschen des Bildes</translation>
    </message>
    <message>
        <source>half the edge of the cubes around the seeds that the first mean is taken of</source>
        <translation>halbe Kante der Würfel um die Saatpunkte, über die der erste Mittelwert gebildet wird</translation>
    </message>
    <message>
        <source>half-width of the accepted intensity range around the region&apos;s mean, in standard deviations</source>
        <translation>halbe Breite des zulässigen Intensitätsbereichs um den Mittelwert der Region, in Standardabweichungen</translation>
    </message>
    <message>
        <source>how far from the evolution&apos;s result the wall is looked for</source>
        <translation>wie weit vom Ergebnis der Evolution die Wand gesucht wird</translation>
    </message>
    <message>
        <source>how far the lumen&apos;s brightness is averaged along the vessels: steps of 2/3 voxel^2</source>
        <translation>wie weit die Helligkeit des Lumens entlang der Gefäße gemittelt wird: Schritte von 2/3 Voxel^2</translation>
    </message>
    <message>
        <source>how often the region is grown anew from its own mean and deviation</source>
        <translation>wie oft die Region aus ihrem eigenen Mittelwert und ihrer Abweichung neu wächst</translation>
    </message>
    <message>
        <source>how the vessels are segmented; label: the image is already a segmentation; the others are for comparison with the level set, from the same seeds</source>
        <translation>wie die Gefäße segmentiert werden; label: das Bild ist schon eine Segmentierung; die übrigen dienen dem Vergleich mit dem Level-Set, aus denselben Saatpunkten</translation>
    </message>
    <message>
        <source>interpolant of phi whose zero set is the wall</source>
        <translation>Interpolante von phi, deren Nullmenge die Wand ist</translation>
    </message>
    <message>
        <source>it takes fewer iterations, and flickers more about steep walls</source>
        <translation>es braucht weniger Iterationen und flimmert stärker an steilen Wänden</translation>
    </message>
    <message>
        <source>iterations between two checks of convergence</source>
        <translation>Iterationen zwischen zwei Prüfungen der Konvergenz</translation>
    </message>
    <message>
        <source>iterations of the curvature flow</source>
        <translation>Iterationen des Krümmungsflusses</translation>
    </message>
    <message>
        <source>keep-wall: largest distance of a vertex from the wall, working voxels</source>
        <translation>keep-wall: größter Abstand eines Knotens von der Wand, Arbeitsvoxel</translation>
    </message>
    <message>
        <source>keep-wall: smooths the triangulation, not the vessel; taubin: as in the thesis</source>
        <translation>keep-wall: glättet die Triangulierung, nicht das Gefäß; taubin: wie in der Thesis</translation>
    </message>
    <message>
        <source>larger surfaces are begun</source>
        <translation>größere Oberflächen werden begonnen</translation>
    </message>
    <message>
        <source>largest intensity of a vessel; auto: none (Otsu&apos;s threshold for dark vessels)</source>
        <translation>größte Intensität eines Gefäßes; auto: keine (für dunkle Gefäße die Schwelle nach Otsu)</translation>
    </message>
    <message>
        <source>largest scale: about the radius of the thickest vessel; auto: 6 working voxels, or by scalesFromImage</source>
        <translation>größte Skala: etwa der Radius des dicksten Gefäßes; auto: 6 Arbeitsvoxel, oder durch scalesFromImage</translation>
    </message>
    <message>
        <source>largest sigma at which the negative branch acts; auto: 2 sigmaMin</source>
        <translation>größtes sigma, bei dem der negative Zweig wirkt; auto: 2 sigmaMin</translation>
    </message>
    <message>
        <source>largest step of the front per iteration; near 0.5 it flickers at steep walls, at 1/6 it comes to rest</source>
        <translation>größter Schritt der Front je Iteration; nahe 0,5 flimmert sie an steilen Wänden, bei 1/6 kommt sie zur Ruhe</translation>
    </message>
    <message>
        <source>least brightness of a vessel voxel, from the surroundings (0) to the lumen (1); the wall lies half-way, or here if this is higher</source>
        <translation>geringste Helligkeit eines Gefäßvoxels, von der Umgebung (0) bis zum Lumen (1); die Wand liegt auf halbem Weg, oder hier, wenn dies höher ist</translation>
    </message>
    <message>
        <source>least intensity of a vessel; auto: Otsu&apos;s threshold (none for dark vessels)</source>
        <translation>kleinste Intensität eines Gefäßes; auto: Schwelle nach Otsu (für dunkle Gefäße keine)</translation>
    </message>
    <message>
        <source>least number of edges around any vessel; none: only the curvature counts</source>
        <translation>Mindestzahl der Kanten um jedes Gefäß; none: nur die Krümmung zählt</translation>
    </message>
    <message>
        <source>less is segmented of images with much noise</source>
        <translation>in Bildern mit viel Rauschen wird weniger segmentiert</translation>
    </message>
    <message>
        <source>less is segmented of images with strong vessels</source>
        <translation>in Bildern mit kräftigen Gefäßen wird weniger segmentiert</translation>
    </message>
    <message>
        <source>less is taken</source>
        <translation>weniger wird genommen</translation>
    </message>
    <message>
        <source>less of bone and calcium is taken out</source>
        <translation>weniger Knochen und Kalk wird entfernt</translation>
    </message>
    <message>
        <source>less of the shrinking is made up for</source>
        <translation>das Schrumpfen wird weniger ausgeglichen</translation>
    </message>
    <message>
        <source>let an automatic sigmaMaxMm grow to half the radius of the thickest bright structure if that exceeds 6 working voxels, at most 15</source>
        <translation>ein automatisches sigmaMaxMm auf den halben Radius der dicksten hellen Struktur wachsen lassen, wenn dieser 6 Arbeitsvoxel übersteigt, höchstens 15</translation>
    </message>
    <message>
        <source>longer edges where the wall is curved</source>
        <translation>längere Kanten, wo die Wand gekrümmt ist</translation>
    </message>
    <message>
        <source>longest wanted edge; none: no limit</source>
        <translation>längste gewünschte Kante; none: keine Grenze</translation>
    </message>
    <message>
        <source>lower bound of b by eq. 3.20</source>
        <translation>untere Grenze von b nach Gl. 3.20</translation>
    </message>
    <message>
        <source>lowest vesselness of an automatic seed (the best one is always kept); stops topPercent from taking noise where there are few vessels</source>
        <translation>kleinste Vesselness eines automatischen Saatpunkts (der beste bleibt immer); verhindert, dass topPercent Rauschen nimmt, wo es wenige Gefäße gibt</translation>
    </message>
    <message>
        <source>make the wall as smooth as the vessel is, within what noise and contrast leave open</source>
        <translation>die Wand so glatt machen, wie das Gefäß es ist, soweit Rauschen und Kontrast es offenlassen</translation>
    </message>
    <message>
        <source>map intensities through a sigmoid that keeps the range of the vessels</source>
        <translation>Intensitäten durch ein Sigmoid abbilden, das den Bereich der Gefäße erhält</translation>
    </message>
    <message>
        <source>modified: eq. 3.22, negative beside vessels; frangi: eq. 3.15</source>
        <translation>modified: Gl. 3.22, neben Gefäßen negativ; frangi: Gl. 3.15</translation>
    </message>
    <message>
        <source>more is taken</source>
        <translation>mehr wird genommen</translation>
    </message>
    <message>
        <source>more of each end is cut off</source>
        <translation>von jedem Ende wird mehr abgeschnitten</translation>
    </message>
    <message>
        <source>more of the dark tissue becomes one grey</source>
        <translation>mehr vom dunklen Gewebe wird zu einem einzigen Grau</translation>
    </message>
    <message>
        <source>most iterations of the evolution</source>
        <translation>Höchstzahl der Iterationen der Evolution</translation>
    </message>
    <message>
        <source>neighbouring triangles are more alike, and there are more of them</source>
        <translation>benachbarte Dreiecke sind einander ähnlicher, und es sind mehr</translation>
    </message>
    <message>
        <source>new names of ports, which are given by their name in the report or by their position in mm LPS</source>
        <translation>neue Namen von Öffnungen, die durch ihren Namen im Bericht oder ihre Lage in mm LPS angegeben werden</translation>
    </message>
    <message>
        <source>noise disturbs the contour less, and thin vessels are lost</source>
        <translation>Rauschen stört die Kontur weniger, und dünne Gefäße gehen verloren</translation>
    </message>
    <message>
        <source>noise disturbs the wall less, and neighbours run together</source>
        <translation>Rauschen stört die Wand weniger, und Nachbarn verschmelzen</translation>
    </message>
    <message>
        <source>noise disturbs the wall less, and short narrow places are filled</source>
        <translation>Rauschen stört die Wand weniger, und kurze Engstellen werden aufgefüllt</translation>
    </message>
    <message>
        <source>noise goes, and then thin vessels</source>
        <translation>das Rauschen verschwindet, danach auch dünne Gefäße</translation>
    </message>
    <message>
        <source>noise goes, and thin vessels are lost</source>
        <translation>das Rauschen verschwindet, und dünne Gefäße gehen verloren</translation>
    </message>
    <message>
        <source>number of scales, evenly spaced in log(sigma); auto: by scaleRule</source>
        <translation>Anzahl der Skalen, gleichmäßig in log(sigma); auto: durch scaleRule</translation>
    </message>
    <message>
        <source>on: only rho sets the accuracy and 1/eta the gradation (eq. 4.4); off: 1/eta shortens the edges too</source>
        <translation>on: nur rho bestimmt die Genauigkeit und 1/eta die Abstufung (Gl. 4.4); off: 1/eta verkürzt auch die Kanten</translation>
    </message>
    <message>
        <source>only stronger edges stop the contour</source>
        <translation>nur stärkere Kanten halten die Kontur an</translation>
    </message>
    <message>
        <source>only the parts that hold a seed</source>
        <translation>nur die Teile, in denen ein Saatpunkt liegt</translation>
    </message>
    <message>
        <source>parts with v &gt;= b and at least this many voxels count as vessels even without a seed</source>
        <translation>Teile mit v &gt;= b und mindestens so vielen Voxeln gelten auch ohne Saatpunkt als Gefäße</translation>
    </message>
    <message>
        <source>place the wall between the brightness of lumen and surroundings, after the evolution</source>
        <translation>die Wand nach der Evolution zwischen die Helligkeit von Lumen und Umgebung legen</translation>
    </message>
    <message>
        <source>planes that cut vessels, in mm LPS, and the names of the openings; the part on the side of the normal is removed; without a normal the cut is straight across and removes the smaller part</source>
        <translation>Ebenen, die Gefäße schneiden, in mm LPS, und die Namen der Öffnungen; der Teil auf der Seite der Normalen wird entfernt; ohne Normale verläuft der Schnitt quer und entfernt den kleineren Teil</translation>
    </message>
    <message>
        <source>plates count less against vessels, so that flat vessels get less</source>
        <translation>Platten zählen weniger gegen Gefäße, flache Gefäße erhalten also weniger</translation>
    </message>
    <message>
        <source>radii between the scales are met better, and it takes longer</source>
        <translation>Radien zwischen den Skalen werden besser getroffen, und es dauert länger</translation>
    </message>
    <message>
        <source>radius of the starting spheres, working voxels</source>
        <translation>Radius der Startkugeln, Arbeitsvoxel</translation>
    </message>
    <message>
        <source>raise darker voxels to this intensity; none: no lower bound</source>
        <translation>dunklere Voxel auf diese Intensität anheben; none: keine untere Grenze</translation>
    </message>
    <message>
        <source>ratio: ceil(log_1.5(max / min)) + 1; difference: eq. 5.1 in working voxels, at least 2</source>
        <translation>ratio: ceil(log_1.5(max / min)) + 1; difference: Gl. 5.1 in Arbeitsvoxeln, mindestens 2</translation>
    </message>
    <message>
        <source>region of interest: two opposite corners x0,y0,z0,x1,y1,z1 in mm LPS</source>
        <translation>Bereich (ROI): zwei gegenüberliegende Ecken x0,y0,z0,x1,y1,z1 in mm LPS</translation>
    </message>
    <message>
        <source>resample to cubic voxels of the smallest spacing; auto: when spacing differs by more than 10 % and the voxels grow at most threefold</source>
        <translation>auf kubische Voxel des kleinsten Abstands neu abtasten; auto: wenn die Abstände um mehr als 10 % abweichen und es höchstens dreimal so viele Voxel werden</translation>
    </message>
    <message>
        <source>robust: 99.9th percentile minus median; range: maximum minus minimum</source>
        <translation>robust: 99,9. Perzentil minus Median; range: Maximum minus Minimum</translation>
    </message>
    <message>
        <source>scale of the gradient that stops the contour</source>
        <translation>Skala des Gradienten, der die Kontur anhält</translation>
    </message>
    <message>
        <source>scales the threshold b</source>
        <translation>skaliert die Schwelle b</translation>
    </message>
    <message>
        <source>seeds by hand, x,y,z,... in mm LPS, added to the automatic ones</source>
        <translation>von Hand gesetzte Saatpunkte, x,y,z,... in mm LPS, zusätzlich zu den automatischen</translation>
    </message>
    <message>
        <source>sensitivity to blobs (R_B)</source>
        <translation>Empfindlichkeit für Blobs (R_B)</translation>
    </message>
    <message>
        <source>sensitivity to plates (R_A)</source>
        <translation>Empfindlichkeit für Platten (R_A)</translation>
    </message>
    <message>
        <source>share of the voxels that become seeds, highest single-scale vesselness first</source>
        <translation>Anteil der Voxel, die Saatpunkte werden, höchste Vesselness einer einzelnen Skala zuerst</translation>
    </message>
    <message>
        <source>short pieces and blobs are left out, however thick they are</source>
        <translation>kurze Stücke und Blobs fallen weg, wie dick sie auch sind</translation>
    </message>
    <message>
        <source>shortest wanted edge; none: no limit</source>
        <translation>kürzeste gewünschte Kante; none: keine Grenze</translation>
    </message>
    <message>
        <source>size of the window that the wall is fitted in, multiplied by the fourth root of (vessel radius x uncertainty of the wall), voxels</source>
        <translation>Größe des Fensters, in dem die Wand angepasst wird, multipliziert mit der vierten Wurzel aus (Gefäßradius x Unsicherheit der Wand), Voxel</translation>
    </message>
    <message>
        <source>slow fronts are not taken for resting ones</source>
        <translation>langsame Fronten werden nicht für ruhende gehalten</translation>
    </message>
    <message>
        <source>small parts are left out</source>
        <translation>kleine Teile fallen weg</translation>
    </message>
    <message>
        <source>small parts without a seed are left out</source>
        <translation>kleine Teile ohne Saatpunkt fallen weg</translation>
    </message>
    <message>
        <source>small pieces of the surface are left out</source>
        <translation>kleine Stücke der Oberfläche fallen weg</translation>
    </message>
    <message>
        <source>smallest scale: about the radius of the thinnest vessel; auto: 1 working voxel</source>
        <translation>kleinste Skala: etwa der Radius des dünnsten Gefäßes; auto: 1 Arbeitsvoxel</translation>
    </message>
    <message>
        <source>smooth along the edges of the image by curvature flow</source>
        <translation>entlang der Kanten des Bildes durch Krümmungsfluss glätten</translation>
    </message>
    <message>
        <source>smoother, and with taubin the vessel&apos;s own detail goes too</source>
        <translation>glatter, und mit taubin gehen auch Einzelheiten des Gefäßes verloren</translation>
    </message>
    <message>
        <source>standard deviation of the image&apos;s point spread; auto: measured at the walls</source>
        <translation>Standardabweichung der Punktbildfunktion des Bildes; auto: an den Wänden gemessen</translation>
    </message>
    <message>
        <source>strength of smoothing across the vessels, multiplied by the squared ratio of noise to contrast</source>
        <translation>Stärke der Glättung quer zu den Gefäßen, multipliziert mit dem quadrierten Verhältnis von Rauschen zu Kontrast</translation>
    </message>
    <message>
        <source>strength of smoothing along the vessels, multiplied by the squared ratio of noise to contrast</source>
        <translation>Stärke der Glättung längs der Gefäße, multipliziert mit dem quadrierten Verhältnis von Rauschen zu Kontrast</translation>
    </message>
    <message>
        <source>strength of the curvature term</source>
        <translation>Stärke des Krümmungsterms</translation>
    </message>
    <message>
        <source>structureness at which the measure saturates, intensities; auto: cFraction of the contrast</source>
        <translation>Strukturstärke, bei der das Maß sättigt, Intensitäten; auto: cFraction des Kontrasts</translation>
    </message>
    <message>
        <source>surface components that enclose less are left out</source>
        <translation>Komponenten der Oberfläche, die weniger einschließen, werden weggelassen</translation>
    </message>
    <message>
        <source>sweeps over the vertices, with taubin pairs of a lambda and a mu step; 0: nothing is smoothed</source>
        <translation>Durchgänge über die Knoten, mit taubin Paare aus einem Lambda- und einem Mu-Schritt; 0: nichts wird geglättet</translation>
    </message>
    <message>
        <source>the components that hold these points, x,y,z,... in mm LPS, are left out</source>
        <translation>die Komponenten, in denen diese Punkte liegen, x,y,z,... in mm LPS, werden weggelassen</translation>
    </message>
    <message>
        <source>the contour ends below this root mean square change of an iteration</source>
        <translation>die Kontur endet, wenn die quadratisch gemittelte Änderung (RMS) einer Iteration kleiner ist</translation>
    </message>
    <message>
        <source>the contour ends here at the latest</source>
        <translation>hier endet die Kontur spätestens</translation>
    </message>
    <message>
        <source>the contour ends sooner</source>
        <translation>die Kontur endet früher</translation>
    </message>
    <message>
        <source>the contour gets smoother, and stays out of thin vessels</source>
        <translation>die Kontur wird glatter und bleibt aus dünnen Gefäßen heraus</translation>
    </message>
    <message>
        <source>the contour goes farther, and leaks sooner</source>
        <translation>die Kontur läuft weiter und leckt früher</translation>
    </message>
    <message>
        <source>the contour holds to edges more</source>
        <translation>die Kontur hält sich stärker an Kanten</translation>
    </message>
    <message>
        <source>the contour stops more abruptly</source>
        <translation>die Kontur hält abrupter an</translation>
    </message>
    <message>
        <source>the curvature is divided by it; 3 imitates the reference program</source>
        <translation>die Krümmung wird dadurch geteilt; 3 ahmt das Referenzprogramm nach</translation>
    </message>
    <message>
        <source>the evolution ends sooner</source>
        <translation>die Evolution endet früher</translation>
    </message>
    <message>
        <source>the first mean takes in more of the surroundings</source>
        <translation>der erste Mittelwert nimmt mehr von der Umgebung auf</translation>
    </message>
    <message>
        <source>the front follows the image more, and is less smooth</source>
        <translation>die Front folgt stärker dem Bild und ist weniger glatt</translation>
    </message>
    <message>
        <source>the front goes farther into thin vessels</source>
        <translation>die Front läuft weiter in dünne Gefäße hinein</translation>
    </message>
    <message>
        <source>the front goes on for longer</source>
        <translation>die Front läuft länger</translation>
    </message>
    <message>
        <source>the front starts farther out, and may begin outside thin vessels</source>
        <translation>die Front beginnt weiter außen, vielleicht außerhalb dünner Gefäße</translation>
    </message>
    <message>
        <source>the interval fits the region more</source>
        <translation>das Intervall passt besser zur Region</translation>
    </message>
    <message>
        <source>the lumen&apos;s brightness is steadier, and follows changes along the vessel less</source>
        <translation>die Helligkeit des Lumens ist gleichmäßiger und folgt Änderungen entlang des Gefäßes weniger</translation>
    </message>
    <message>
        <source>the region grows, and leaks sooner</source>
        <translation>die Region wächst und leckt früher</translation>
    </message>
    <message>
        <source>the step from dark to bright gets gentler</source>
        <translation>der Übergang von dunkel zu hell wird sanfter</translation>
    </message>
    <message>
        <source>the thinnest vessels are lost, and so is noise</source>
        <translation>die dünnsten Gefäße gehen verloren, und das Rauschen auch</translation>
    </message>
    <message>
        <source>the wall gets smoother, and short bulges and dents are lost</source>
        <translation>die Wand wird glatter, und kurze Ausbuchtungen und Dellen gehen verloren</translation>
    </message>
    <message>
        <source>thicker vessels are found, neighbours may run together, and it takes longer</source>
        <translation>dickere Gefäße werden gefunden, Nachbarn können verschmelzen, und es dauert länger</translation>
    </message>
    <message>
        <source>thicker vessels are kept apart as well</source>
        <translation>auch dickere Gefäße werden getrennt gehalten</translation>
    </message>
    <message>
        <source>thin vessels are taken for thinner than they look</source>
        <translation>dünne Gefäße gelten als dünner, als sie aussehen</translation>
    </message>
    <message>
        <source>thin vessels get rounder, of more triangles</source>
        <translation>dünne Gefäße werden runder, mit mehr Dreiecken</translation>
    </message>
    <message>
        <source>time step of the curvature flow, in voxels whatever their size; 0.0625 is stable</source>
        <translation>Zeitschritt des Krümmungsflusses, in Voxeln ungeachtet ihrer Größe; 0,0625 ist stabil</translation>
    </message>
    <message>
        <source>upper bound of b by eq. 3.20</source>
        <translation>obere Grenze von b nach Gl. 3.20</translation>
    </message>
    <message>
        <source>value of the voxels of a segmentation that are vessel</source>
        <translation>Wert der Voxel einer Segmentierung, die Gefäß sind</translation>
    </message>
    <message>
        <source>vertices may leave the wall farther</source>
        <translation>Knoten dürfen sich weiter von der Wand entfernen</translation>
    </message>
    <message>
        <source>vesselness at which the front stands still; auto: by bRule</source>
        <translation>Vesselness, bei der die Front stillsteht; auto: durch bRule</translation>
    </message>
    <message>
        <source>vessels are brighter or darker than their surroundings</source>
        <translation>Gefäße sind heller oder dunkler als ihre Umgebung</translation>
    </message>
    <message>
        <source>vessels get thinner, and narrow ones part</source>
        <translation>Gefäße werden dünner, und enge reißen ab</translation>
    </message>
    <message>
        <source>walls farther out are found, and it takes longer</source>
        <translation>weiter entfernte Wände werden gefunden, und es dauert länger</translation>
    </message>
    <message>
        <source>weight of the contour&apos;s outward speed</source>
        <translation>Gewicht der nach außen gerichteten Geschwindigkeit der Kontur</translation>
    </message>
    <message>
        <source>weight of the growing step</source>
        <translation>Gewicht des Wachstumsschritts</translation>
    </message>
    <message>
        <source>weight of the shrinking step</source>
        <translation>Gewicht des Schrumpfschritts</translation>
    </message>
    <message>
        <source>weight of the term that draws the contour to edges</source>
        <translation>Gewicht des Terms, der die Kontur zu Kanten zieht</translation>
    </message>
    <message>
        <source>weight of the term that smooths the contour</source>
        <translation>Gewicht des Terms, der die Kontur glättet</translation>
    </message>
    <message>
        <source>weight of the vesselness term against the curvature term</source>
        <translation>Gewicht des Vesselness-Terms gegenüber dem Krümmungsterm</translation>
    </message>
    <message>
        <source>where a vessel leaves the volume: a flat cap or an open rim</source>
        <translation>wo ein Gefäß das Volumen verlässt: ein ebener Deckel oder ein offener Rand</translation>
    </message>
    <message>
        <source>which components go into the surface; seeded: those that hold a seed given by hand</source>
        <translation>welche Komponenten in die Oberfläche kommen; seeded: die mit einem von Hand gesetzten Saatpunkt</translation>
    </message>
    <message>
        <source>which voxels of a mask or label are joined: those that share a face (6 neighbours), an edge too (18) or a corner too (26)</source>
        <translation>welche Voxel einer Maske oder eines Labels verbunden sind: die mit gemeinsamer Fläche (6 Nachbarn), auch Kante (18) oder auch Ecke (26)</translation>
    </message>
    <message>
        <source>width of a Gaussian before the threshold; 0: none</source>
        <translation>Breite eines Gauß-Filters vor der Schwelle; 0: keiner</translation>
    </message>
    <message>
        <source>width of that rim, in voxels of the input</source>
        <translation>Breite dieses Saums, in Voxeln der Eingabe</translation>
    </message>
    <message>
        <source>width of the sigmoid of the gradient magnitude, negative; auto: from the image&apos;s contrast and noise</source>
        <translation>Breite des Sigmoids des Gradientenbetrags, negativ; auto: aus Kontrast und Rauschen des Bildes</translation>
    </message>
    <message>
        <source>width of the sigmoid, as the viewer&apos;s window; auto: 1st to 99.8th percentile</source>
        <translation>Breite des Sigmoids, wie das Fenster der Anzeige; auto: 1. bis 99,8. Perzentil</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>corrections of the segmentation by hand, made in their order after the evolution</source>
        <translation>Korrekturen der Segmentierung von Hand, der Reihe nach nach der Evolution ausgeführt</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>Any CT angiography in HU: bone and what is darker than water are put aside.</source>
        <translation>Jede CT-Angiographie in HU: Knochen und alles, was dunkler als Wasser ist, bleiben außer Betracht.</translation>
    </message>
    <message>
        <source>CT angiography of the head in HU: as ct, vessels up to 6 mm wide; separate parts shorter than 10 mm are left out.</source>
        <translation>CT-Angiographie des Kopfes in HU: wie ct, Gefäße bis 6 mm Weite; einzelne Teile kürzer als 10 mm werden ausgelassen.</translation>
    </message>
    <message>
        <source>Contrast-enhanced MR angiography of pelvis and legs: vessels up to 12 mm wide; separate parts shorter than 30 mm are left out.</source>
        <translation>MR-Angiographie von Becken und Beinen mit Kontrastmittel: Gefäße bis 12 mm Weite; einzelne Teile kürzer als 30 mm werden ausgelassen.</translation>
    </message>
    <message>
        <source>Contrast-enhanced MR angiography of the abdomen: vessels up to 25 mm wide; separate parts shorter than 30 mm are left out.</source>
        <translation>MR-Angiographie des Bauchraums mit Kontrastmittel: Gefäße bis 25 mm Weite; einzelne Teile kürzer als 30 mm werden ausgelassen.</translation>
    </message>
    <message>
        <source>The default: any MR angiography in which vessels are the brightest thing.</source>
        <translation>Die Standardvorgabe: jede MR-Angiographie, in der die Gefäße das Hellste sind.</translation>
    </message>
    <message>
        <source>The method as printed in the thesis, for comparison: slower and less accurate.</source>
        <translation>Die Methode, wie sie in der Arbeit gedruckt ist, zum Vergleich: langsamer und weniger genau.</translation>
    </message>
    <message>
        <source>Time-of-flight MR angiography of the brain: vessels up to 6 mm wide; separate parts shorter than 10 mm are left out.</source>
        <translation>Time-of-Flight-MR-Angiographie des Gehirns: Gefäße bis 6 mm Weite; einzelne Teile kürzer als 10 mm werden ausgelassen.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Save case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>There is a case %1 already. Replace it?</source>
        <translation>Es gibt schon einen Fall %1. Soll er ersetzt werden?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The case %1 has changes that are not saved.</source>
        <translation>Der Fall %1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Restore edits</source>
        <translation>Änderungen wiederherstellen</translation>
    </message>
    <message>
        <source>Angiomesh ended before these changes were saved:
%1</source>
        <translation>Angiomesh endete, bevor diese Änderungen gespeichert waren:
%1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Ask again later</source>
        <translation>Später fragen</translation>
    </message>
    <message>
        <source>The volume of this case is not where it was, nor beside the case:
%1</source>
        <translation>Das Volumen dieses Falls liegt weder am alten Ort noch neben dem Fall:
%1</translation>
    </message>
    <message>
        <source>The case cannot be opened with this volume: %1.</source>
        <translation>Der Fall lässt sich mit diesem Volumen nicht öffnen: %1.</translation>
    </message>
    <message>
        <source>Where is the volume?</source>
        <translation>Wo ist das Volumen?</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Choose a DICOM folder…</source>
        <translation>DICOM-Ordner wählen…</translation>
    </message>
    <message>
        <source>Open it with the case&apos;s parameters only</source>
        <translation>Nur mit den Parametern des Falls öffnen</translation>
    </message>
    <message>
        <source>Seeds, the region of interest and the parts left out are places in the other volume and are not taken over.</source>
        <translation>Saatpunkte, ROI und weggelassene Teile sind Stellen im anderen Volumen und werden nicht übernommen.</translation>
    </message>
    <message>
        <source>Save case as</source>
        <translation>Fall speichern unter</translation>
    </message>
    <message>
        <source>Cases (*.angiomesh)</source>
        <translation>Fälle (*.angiomesh)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Volumen öffnen</translation>
    </message>
    <message>
        <source>Volumes (*%1);;Cases (case.json);;All files (*)</source>
        <translation>Volumen (*%1);;Fälle (case.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>DICOM-Ordner öffnen</translation>
    </message>
    <message>
        <source>Import ports</source>
        <translation>Öffnungen importieren</translation>
    </message>
    <message>
        <source>Ports (*.json);;All files (*)</source>
        <translation>Öffnungen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>About Angiomesh</source>
        <translation>Über Angiomesh</translation>
    </message>
    <message>
        <source>Angiomesh %1

From an angiogram to a vessel surface that a flow solver accepts.
Not a medical device: research use only.

BSD-3-Clause.</source>
        <translation>Angiomesh %1

Von der Angiographie zur Gefäßoberfläche, die ein Strömungslöser annimmt.
Kein Medizinprodukt: nur für die Forschung.

BSD-3-Clause.</translation>
    </message>
    <message>
        <source>Uneven slices</source>
        <translation>Ungleiche Abstände</translation>
    </message>
    <message>
        <source>The slices of the series are not at even distances.</source>
        <translation>Die Schichten der Serie haben keine gleichen Abstände.</translation>
    </message>
    <message>
        <source>Resample them</source>
        <translation>Neu abtasten</translation>
    </message>
    <message>
        <source>measure a distance</source>
        <translation>Abstand messen</translation>
    </message>
    <message>
        <source>measure a section</source>
        <translation>Querschnitt messen</translation>
    </message>
    <message>
        <source>measure the diameter along a branch</source>
        <translation>Durchmesser entlang eines Astes messen</translation>
    </message>
    <message>
        <source>measure a stenosis</source>
        <translation>Stenose messen</translation>
    </message>
    <message>
        <source>Ø min %1, max %2, of the area %3 mm; area %4 mm²</source>
        <translation>Ø min. %1, max. %2, flächengleich %3 mm; Fläche %4 mm²</translation>
    </message>
    <message>
        <source>Ø %1 to %2, mean %3 mm, along %4 mm</source>
        <translation>Ø %1 bis %2, Mittel %3 mm, auf %4 mm</translation>
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
        <translation>Nach Fläche</translation>
    </message>
    <message>
        <source>D, A: least diameter and area of the narrowest section between the two places. Proximal is the place that was clicked first, distal the second.</source>
        <translation>D, A: kleinster Durchmesser und Fläche des engsten Querschnitts zwischen den beiden Stellen. Proximal ist die zuerst angeklickte Stelle, distal die zweite.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>Stenosis</source>
        <translation>Stenose</translation>
    </message>
    <message>
        <source>Click the two ends of a distance.</source>
        <translation>Die beiden Enden eines Abstands anklicken.</translation>
    </message>
    <message>
        <source>Click the other end.</source>
        <translation>Das andere Ende anklicken.</translation>
    </message>
    <message>
        <source>Click a vessel where it is to be cut across.</source>
        <translation>Ein Gefäß dort anklicken, wo es quer geschnitten werden soll.</translation>
    </message>
    <message>
        <source>Click a branch to see its diameter from end to end.</source>
        <translation>Einen Ast anklicken, um seinen Durchmesser von einem Ende zum anderen zu sehen.</translation>
    </message>
    <message>
        <source>Click the vessel where it is normal, first on the side that the blood comes from, then behind the narrowing.</source>
        <translation>Das Gefäß dort anklicken, wo es normal ist: zuerst auf der Seite, von der das Blut kommt, dann hinter der Engstelle.</translation>
    </message>
    <message>
        <source>Click the vessel where it is normal again, behind the narrowing.</source>
        <translation>Das Gefäß dort anklicken, wo es hinter der Engstelle wieder normal ist.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>NASCET %1, WASID %2, by area %3</source>
        <translation>NASCET %1, WASID %2, nach Fläche %3</translation>
    </message>
    <message>
        <source>In a straight line from one place to the other.</source>
        <translation>In gerader Linie von einer Stelle zur anderen.</translation>
    </message>
    <message>
        <source>Across the vessel&apos;s axis. Min: the least distance of two parallel lines that hold the outline between them. Max: the greatest distance of two of its points. Of the area: the circle that is as large, √(4 A / π).</source>
        <translation>Quer zur Gefäßachse. Min.: kleinster Abstand zweier paralleler Geraden, die den Umriss zwischen sich fassen. Max.: größter Abstand zweier seiner Punkte. Flächengleich: der ebenso große Kreis, √(4 A / π).</translation>
    </message>
    <message>
        <source>Diameter of the circle as large as the section across the centre line, from end to end of the branch; thin: least diameter. Left out where vessels part.</source>
        <translation>Durchmesser des Kreises, der so groß ist wie der Querschnitt zur Mittellinie, von einem Ende des Astes zum anderen; dünn: kleinster Durchmesser. Ausgelassen, wo sich Gefäße teilen.</translation>
    </message>
    <message>
        <source>%1, out of date</source>
        <translation>%1, veraltet</translation>
    </message>
    <message>
        <source>Evolving, back at iteration %1</source>
        <translation>Evolution, zurück bei Iteration %1</translation>
    </message>
    <message>
        <source>Result %1, the front after iteration %2</source>
        <translation>Ergebnis %1, Front nach Iteration %2</translation>
    </message>
    <message>
        <source>Evolving, iteration %1</source>
        <translation>Evolution, Iteration %1</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>Source (no %1 yet)</source>
        <translation>Quelle (es fehlt noch: %1)</translation>
    </message>
    <message>
        <source>No %1 yet to lay over it</source>
        <translation>Zum Überlagern fehlt noch: %1</translation>
    </message>
    <message>
        <source>%1 over it</source>
        <translation>%1 darüber</translation>
    </message>
    <message>
        <source>%1, no mesh yet</source>
        <translation>%1, noch kein Netz</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Preprocessed</source>
        <translation>Vorverarbeitet</translation>
    </message>
    <message>
        <source>Vesselness</source>
        <translation>Vesselness</translation>
    </message>
    <message>
        <source>Speed p</source>
        <translation>Geschwind. p</translation>
    </message>
    <message>
        <source>exported (smoothed)</source>
        <translation>exportiert (geglättet)</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>nicht geglättet</translation>
    </message>
    <message>
        <source>marching cubes</source>
        <translation>Marching Cubes</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels of %4 × %5 × %6 mm</source>
        <translation>%1 × %2 × %3 Voxel von %4 × %5 × %6 mm</translation>
    </message>
    <message>
        <source>a few seconds</source>
        <translation>ein paar Sekunden</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>Evolve</source>
        <translation>Evolution</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Preprocess</source>
        <translation>Vorverarbeitung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Saatpunkte</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Compare with a mesh</source>
        <translation>Mit einem Netz vergleichen</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Netze (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mesh from a file</source>
        <translation>Netz aus einer Datei</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>aus einer Datei</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Korrigieren</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Vorgabe einlesen</translation>
    </message>
    <message>
        <source>There is a preset %1 already. Replace it?</source>
        <translation>Es gibt schon eine Vorgabe %1. Soll sie ersetzt werden?</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Vorgabe entfernen</translation>
    </message>
    <message>
        <source>Remove the preset %1 for good? The parameters in use stay.</source>
        <translation>Vorgabe %1 endgültig entfernen? Die Parameter in Gebrauch bleiben.</translation>
    </message>
    <message>
        <source>Presets, recipes and parameters (*.json);;All files (*)</source>
        <translation>Vorgaben, Rezepte und Parameter (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Revie&amp;w</source>
        <translation>&amp;Prüfung</translation>
    </message>
    <message>
        <source>Open the review</source>
        <translation>Prüfung öffnen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Next doubtful place</source>
        <translation>Nächste fragliche Stelle</translation>
    </message>
    <message>
        <source>Previous doubtful place</source>
        <translation>Vorige fragliche Stelle</translation>
    </message>
    <message>
        <source>Add a remark at the crosshair</source>
        <translation>Anmerkung am Fadenkreuz hinzufügen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+M</source>
        <translation>Ctrl+Alt+M</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Rechnen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Sensitivity to the parameters</source>
        <translation>Empfindlichkeit gegen die Parameter</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: passes</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: erfüllt</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: fails, %2 of %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: nicht erfüllt, %2 von %3</translation>
    </message>
</context>
<context>
    <name>QualityGate</name>
    <message>
        <source>A triangle without area has no normal.</source>
        <translation>Ein Dreieck ohne Fläche hat keine Normale.</translation>
    </message>
    <message>
        <source>Close the ends: surface.border cap.</source>
        <translation>Enden schließen: surface.border cap.</translation>
    </message>
    <message>
        <source>Flat triangles make flat cells beside the wall, where the solution is inexact.</source>
        <translation>Flache Dreiecke ergeben flache Zellen an der Wand, wo die Lösung ungenau ist.</translation>
    </message>
    <message>
        <source>Inside and outside cannot be told apart.</source>
        <translation>Innen und außen lassen sich nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Leave parts out: untick them, or raise segmentation.minVolumeMm3.</source>
        <translation>Teile weglassen: abwählen oder segmentation.minVolumeMm3 erhöhen.</translation>
    </message>
    <message>
        <source>Make surface.rho smaller: edges get shorter where the wall bends.</source>
        <translation>surface.rho verkleinern: Die Kanten werden kürzer, wo sich die Wand biegt.</translation>
    </message>
    <message>
        <source>Mesh the segmentation with surface.method advancing-front.</source>
        <translation>Die Segmentierung mit surface.method advancing-front vernetzen.</translation>
    </message>
    <message>
        <source>Parts that do not hang together fall apart.</source>
        <translation>Teile, die nicht zusammenhängen, fallen auseinander.</translation>
    </message>
    <message>
        <source>The inside leaks through open rims.</source>
        <translation>Durch offene Ränder läuft das Innere aus.</translation>
    </message>
    <message>
        <source>There is no surface.</source>
        <translation>Es gibt keine Oberfläche.</translation>
    </message>
    <message>
        <source>Volume meshers refuse a surface that forks at an edge.</source>
        <translation>Volumenvernetzer lehnen eine Oberfläche ab, die sich an einer Kante verzweigt.</translation>
    </message>
    <message>
        <source>Volume meshers refuse a surface that touches itself at a vertex.</source>
        <translation>Volumenvernetzer lehnen eine Oberfläche ab, die sich in einem Knoten berührt.</translation>
    </message>
    <message>
        <source>What is thinner than the strand of a usual nozzle (0.4 mm wide) breaks or is left out.</source>
        <translation>Was dünner ist als der Strang einer üblichen Düse (0,4 mm breit), bricht oder fällt weg.</translation>
    </message>
    <message>
        <source>Where the surface cuts itself, inside and outside are not defined.</source>
        <translation>Wo sich die Oberfläche selbst schneidet, sind innen und außen nicht definiert.</translation>
    </message>
    <message>
        <source>as closed, all angles from 30 to 110 degrees, all radius ratios at least 0.6</source>
        <translation>wie closed, alle Winkel von 30 bis 110 Grad, alle Radienverhältnisse mindestens 0,6</translation>
    </message>
    <message>
        <source>as closed, and no angle below 15 degrees</source>
        <translation>wie closed, und kein Winkel unter 15 Grad</translation>
    </message>
    <message>
        <source>as closed, in one part, and thinner than 0.5 mm at no more than 1 % of the triangles</source>
        <translation>wie closed, aus einem Teil, und bei höchstens 1 % der Dreiecke dünner als 0,5 mm</translation>
    </message>
    <message>
        <source>as manifold, and no boundary edge</source>
        <translation>wie manifold, und keine Randkante</translation>
    </message>
    <message>
        <source>oriented, no non-manifold spot, degenerate triangle or self-intersection</source>
        <translation>orientiert, keine Non-Manifold-Stelle, kein entartetes Dreieck, kein Selbstschnitt</translation>
    </message>
</context>
<context>
    <name>QualityMeasure</name>
    <message>
        <source>Verified parts</source>
        <translation>Geprüfte Teile</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>1st percentile</source>
        <translation>1. Perzentil</translation>
    </message>
    <message>
        <source>1st percentile of the smallest angle of each triangle</source>
        <translation>1. Perzentil des kleinsten Winkels jedes Dreiecks</translation>
    </message>
    <message>
        <source>2 * inradius / circumradius; 1 is equilateral</source>
        <translation>2 * Inkreisradius / Umkreisradius; 1 ist gleichseitig</translation>
    </message>
    <message>
        <source>99th percentile of the largest angle of each triangle</source>
        <translation>99. Perzentil des größten Winkels jedes Dreiecks</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Aspect ratio, mean</source>
        <translation>Seitenverh., Mittel</translation>
    </message>
    <message>
        <source>Aspect ratio, most</source>
        <translation>Seitenverh., max.</translation>
    </message>
    <message>
        <source>Below 20 deg</source>
        <translation>Unter 20°</translation>
    </message>
    <message>
        <source>Below 30 deg</source>
        <translation>Unter 30°</translation>
    </message>
    <message>
        <source>Boundary edges</source>
        <translation>Randkanten</translation>
    </message>
    <message>
        <source>Boundary loops</source>
        <translation>Randschleifen</translation>
    </message>
    <message>
        <source>Centroid off, 99 %</source>
        <translation>Schwerp.abw., 99 %</translation>
    </message>
    <message>
        <source>Centroid off, mean</source>
        <translation>Schwerp.abw., Mittel</translation>
    </message>
    <message>
        <source>Centroid off, most</source>
        <translation>Schwerp.abw., max.</translation>
    </message>
    <message>
        <source>Centroid x curv., 99 %</source>
        <translation>Schwerp. x Krümm., 99 %</translation>
    </message>
    <message>
        <source>Centroid x curv., mean</source>
        <translation>Schwerp. x Krümm., Mittel</translation>
    </message>
    <message>
        <source>Centroid x curv., most</source>
        <translation>Schwerp. x Krümm., max.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Corner triangles</source>
        <translation>Eckdreiecke</translation>
    </message>
    <message>
        <source>Degenerate triangles</source>
        <translation>Entartete Dreiecke</translation>
    </message>
    <message>
        <source>Edge, mean</source>
        <translation>Kante, Mittel</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Eulerzahl</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Aus der Front</translation>
    </message>
    <message>
        <source>Gaps below an edge</source>
        <translation>Spalte unter 1 Kante</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Gradation, 99 %</source>
        <translation>Abstufung, 99 %</translation>
    </message>
    <message>
        <source>Gradation, most</source>
        <translation>Abstufung, max.</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>Max. Winkel</translation>
    </message>
    <message>
        <source>Least angle</source>
        <translation>Min. Winkel</translation>
    </message>
    <message>
        <source>Least radius ratio</source>
        <translation>Min. Radienverhältnis</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Max angle, 99 %</source>
        <translation>Max. Winkel, 99 %</translation>
    </message>
    <message>
        <source>Max angle, corners</source>
        <translation>Max. Winkel, Ecken</translation>
    </message>
    <message>
        <source>Max angle, others</source>
        <translation>Max. Winkel, übrige</translation>
    </message>
    <message>
        <source>Min angle, 1 %</source>
        <translation>Min. Winkel, 1 %</translation>
    </message>
    <message>
        <source>Min angle, corners</source>
        <translation>Min. Winkel, Ecken</translation>
    </message>
    <message>
        <source>Min angle, mean</source>
        <translation>Min. Winkel, Mittel</translation>
    </message>
    <message>
        <source>Min angle, others</source>
        <translation>Min. Winkel, übrige</translation>
    </message>
    <message>
        <source>Min ratio, corners</source>
        <translation>Min. Verh., Ecken</translation>
    </message>
    <message>
        <source>Min ratio, others</source>
        <translation>Min. Verh., übrige</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Non-Manifold-Kanten</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>Non-Manifold-Knoten</translation>
    </message>
    <message>
        <source>Oriented</source>
        <translation>Orientiert</translation>
    </message>
    <message>
        <source>Radius ratio, 1 %</source>
        <translation>Radienverh., 1 %</translation>
    </message>
    <message>
        <source>Radius ratio, mean</source>
        <translation>Radienverh., Mittel</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Roughness, 95 %</source>
        <translation>Rauheit, 95 %</translation>
    </message>
    <message>
        <source>Roughness, angle</source>
        <translation>Rauheit, Winkel</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>Selbstschnitte</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>Kürzeste Kante</translation>
    </message>
    <message>
        <source>Skewness, mean</source>
        <translation>Schiefe, Mittel</translation>
    </message>
    <message>
        <source>Skewness, most</source>
        <translation>Schiefe, max.</translation>
    </message>
    <message>
        <source>Thickness, 1 %</source>
        <translation>Dicke, 1 %</translation>
    </message>
    <message>
        <source>Thinnest gap</source>
        <translation>Engster Spalt</translation>
    </message>
    <message>
        <source>Thinnest part</source>
        <translation>Dünnste Stelle</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Valence 5 to 7</source>
        <translation>Valenz 5 bis 7</translation>
    </message>
    <message>
        <source>Valence, least</source>
        <translation>Valenz, min.</translation>
    </message>
    <message>
        <source>Valence, most</source>
        <translation>Valenz, max.</translation>
    </message>
    <message>
        <source>Vertex off, 99 %</source>
        <translation>Knotenabw., 99 %</translation>
    </message>
    <message>
        <source>Vertex off, mean</source>
        <translation>Knotenabw., Mittel</translation>
    </message>
    <message>
        <source>Vertex off, most</source>
        <translation>Knotenabw., max.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>by the divergence theorem, positive for outward faces; absent if not closed and oriented</source>
        <translation>nach dem Gaußschen Integralsatz, positiv bei nach außen gerichteten Flächen; fehlt, wenn nicht geschlossen und orientiert</translation>
    </message>
    <message>
        <source>distance from the zero set of the interpolant that was meshed, caps apart</source>
        <translation>Abstand von der Nullmenge der vernetzten Interpolante, ohne Deckel</translation>
    </message>
    <message>
        <source>edge-connected sets of triangles</source>
        <translation>über Kanten zusammenhängende Mengen von Dreiecken</translation>
    </message>
    <message>
        <source>edges of more than two triangles</source>
        <translation>Kanten von mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>equiangular skewness, as in Fluent: max((largest angle - 60) / 120, (60 - smallest) / 60); 0 is equilateral, 1 has no area</source>
        <translation>gleichwinklige Schiefe wie in Fluent: max((größter Winkel - 60) / 120, (60 - kleinster) / 60); 0 ist gleichseitig, 1 hat keine Fläche</translation>
    </message>
    <message>
        <source>exactly collinear or repeated corners</source>
        <translation>genau kollineare oder doppelte Ecken</translation>
    </message>
    <message>
        <source>from the centroid of a triangle straight inwards to the other side, caps apart; beside a sharp edge it is short</source>
        <translation>vom Schwerpunkt eines Dreiecks geradewegs nach innen zur anderen Seite, ohne Deckel; neben einer scharfen Kante ist es kurz</translation>
    </message>
    <message>
        <source>from the centroid of a triangle straight outwards to the wall again, in mean edges of the triangle; absent if none is below 3</source>
        <translation>vom Schwerpunkt eines Dreiecks geradewegs nach außen bis wieder zur Wand, in mittleren Kanten des Dreiecks; fehlt, wenn nichts unter 3 liegt</translation>
    </message>
    <message>
        <source>in all others</source>
        <translation>in allen übrigen</translation>
    </message>
    <message>
        <source>in such triangles</source>
        <translation>in solchen Dreiecken</translation>
    </message>
    <message>
        <source>its 95th percentile; branchings and tips raise it</source>
        <translation>sein 95. Perzentil; Verzweigungen und Spitzen erhöhen es</translation>
    </message>
    <message>
        <source>longest edge / (inradius * 12^0.5); 1 is equilateral</source>
        <translation>längste Kante / (Inkreisradius * 12^0.5); 1 ist gleichseitig</translation>
    </message>
    <message>
        <source>mean edge of a triangle over that of a neighbour, the larger over the smaller one; 1 is even</source>
        <translation>mittlere Kante eines Dreiecks zu der eines Nachbarn, die größere zur kleineren; 1 ist gleichmäßig</translation>
    </message>
    <message>
        <source>median of the angle between neighbouring triangles that neither their size nor the curvature of the wall explains</source>
        <translation>Median des Winkels zwischen Nachbardreiecken, den weder ihre Größe noch die Krümmung der Wand erklärt</translation>
    </message>
    <message>
        <source>median of the vertices&apos; root mean square distance from a smooth fit around them, see report.md</source>
        <translation>Median des quadratisch gemittelten Abstands der Knoten von einer glatten Anpassung um sie, siehe report.md</translation>
    </message>
    <message>
        <source>neighbours agree on the outside</source>
        <translation>Nachbarn stimmen überein, wo außen ist</translation>
    </message>
    <message>
        <source>no boundary edge</source>
        <translation>keine Randkante</translation>
    </message>
    <message>
        <source>of open rims</source>
        <translation>von offenen Rändern</translation>
    </message>
    <message>
        <source>of the triangles, by smallest angle</source>
        <translation>der Dreiecke, nach kleinstem Winkel</translation>
    </message>
    <message>
        <source>of the triangles: tetrahedra between the walls would be flat</source>
        <translation>der Dreiecke: Tetraeder zwischen den Wänden wären flach</translation>
    </message>
    <message>
        <source>of the vertices, open rims apart</source>
        <translation>der Knoten, ohne offene Ränder</translation>
    </message>
    <message>
        <source>open rims</source>
        <translation>offene Ränder</translation>
    </message>
    <message>
        <source>pairs of triangles that meet outside shared corners and edges, by exact predicates</source>
        <translation>Paare von Dreiecken, die sich außerhalb gemeinsamer Ecken und Kanten treffen, mit exakten Prädikaten</translation>
    </message>
    <message>
        <source>points that triangles use</source>
        <translation>Punkte, die Dreiecke benutzen</translation>
    </message>
    <message>
        <source>share of the triangles that the advancing front made; absent for other methods</source>
        <translation>Anteil der Dreiecke, die die vorrückende Front erzeugt hat; fehlt bei anderen Methoden</translation>
    </message>
    <message>
        <source>sum of 2 - 2 genus - rims</source>
        <translation>Summe von 2 - 2 Geschlecht - Ränder</translation>
    </message>
    <message>
        <source>sum over the components</source>
        <translation>Summe über die Komponenten</translation>
    </message>
    <message>
        <source>the same of the centroids of the triangles</source>
        <translation>dasselbe für die Schwerpunkte der Dreiecke</translation>
    </message>
    <message>
        <source>the smallest of all angles; gates leave out corners of the outline</source>
        <translation>der kleinste aller Winkel; die Kriterien lassen Ecken des Umrisses aus</translation>
    </message>
    <message>
        <source>those with two sides on the borders of two other patches, whose angles no mesher chooses; absent if there are none</source>
        <translation>die mit zwei Seiten auf den Rändern zweier anderer Patches, deren Winkel kein Vernetzer wählt; fehlt, wenn es keine gibt</translation>
    </message>
    <message>
        <source>times the largest principal curvature there, a pure number: about 0.008 for the triangles of an inscribed surface with 20 edges around a tube</source>
        <translation>mal größte Hauptkrümmung dort, eine reine Zahl: etwa 0,008 für die Dreiecke einer einbeschriebenen Oberfläche mit 20 Kanten um ein Rohr</translation>
    </message>
    <message>
        <source>triangles at a vertex, open rims apart; 6 in an even mesh</source>
        <translation>Dreiecke an einem Knoten, ohne offene Ränder; 6 in einem gleichmäßigen Netz</translation>
    </message>
    <message>
        <source>vertices whose triangles do not form a single fan</source>
        <translation>Knoten, deren Dreiecke keinen einzelnen Fächer bilden</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Report on a vessel mesh</source>
        <translation>Bericht über ein Gefäßnetz</translation>
    </message>
    <message>
        <source>Scan: %1</source>
        <translation>Aufnahme: %1</translation>
    </message>
    <message>
        <source>Angiomesh %1. Not a medical device: research use only.</source>
        <translation>Angiomesh %1. Kein Medizinprodukt: nur für die Forschung.</translation>
    </message>
    <message>
        <source>No patient, date or file is named here; remarks and names of measurements and openings stand as they were typed.</source>
        <translation>Patient, Datum und Datei sind hier nicht genannt; Anmerkungen und die Namen von Messungen und Öffnungen stehen so da, wie sie eingegeben wurden.</translation>
    </message>
    <message>
        <source>Not measured: run to the end.</source>
        <translation>Nicht gemessen: bis zum Ende rechnen.</translation>
    </message>
    <message>
        <source>★ marks what is better than in the other meshes.</source>
        <translation>★ bezeichnet, was besser ist als in den anderen Netzen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>(on an earlier wall)</source>
        <translation>(auf einer früheren Wand)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>score %1 of %2</source>
        <translation>Wertung %1 von %2</translation>
    </message>
    <message>
        <source>given to an earlier segmentation</source>
        <translation>für eine frühere Segmentierung vergeben</translation>
    </message>
    <message>
        <source>Doubtful places looked at: %1</source>
        <translation>Angesehene fragliche Stellen: %1</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Anmerkung</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Those that differ from the program&apos;s own are bold.</source>
        <translation>Fett sind die, die von den Vorgaben des Programms abweichen.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
</context>
<context>
    <name>Shortcut</name>
    <message>
        <source>Left drag on a slice</source>
        <translation>Schicht mit linker Taste ziehen</translation>
    </message>
    <message>
        <source>Window and level (Engineering: crosshair; Ctrl: fine)</source>
        <translation>Fenster und Mitte (Engineering: Fadenkreuz; Ctrl: fein)</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>Linksklick</translation>
    </message>
    <message>
        <source>Crosshair in all panes; in 3D on the surface</source>
        <translation>Fadenkreuz in allen Ansichten; in 3D auf der Oberfläche</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Mittlere Taste ziehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Rechte Taste ziehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Wheel on a slice</source>
        <translation>Mausrad auf einer Schicht</translation>
    </message>
    <message>
        <source>Next or previous slice</source>
        <translation>Nächste oder vorige Schicht</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+Mausrad</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+Mausrad</translation>
    </message>
    <message>
        <source>Slab thickness</source>
        <translation>Slab-Dicke</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Shift+Bewegen</translation>
    </message>
    <message>
        <source>Crosshair in all panes</source>
        <translation>Fadenkreuz in allen Ansichten</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Menu: windows; cut the vessel there; on a port: flip, rename, delete</source>
        <translation>Menü: Fenster; Gefäß dort schneiden; auf einer Öffnung: umdrehen, umbenennen, löschen</translation>
    </message>
    <message>
        <source>Left drag on a port</source>
        <translation>Öffnung mit linker Taste ziehen</translation>
    </message>
    <message>
        <source>Along the vessel (Shift: anywhere); by the arrow: tilt</source>
        <translation>Entlang des Gefäßes (Shift: beliebig); am Pfeil: kippen</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>One pane at full size, and back</source>
        <translation>Eine Ansicht in voller Größe, und zurück</translation>
    </message>
    <message>
        <source>Arrow keys over a slice</source>
        <translation>Pfeiltasten über einer Schicht</translation>
    </message>
    <message>
        <source>Next or previous slice (Shift: by 10)</source>
        <translation>Nächste oder vorige Schicht (Shift: um 10)</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset the pane under the mouse</source>
        <translation>Ansicht unter der Maus zurücksetzen</translation>
    </message>
    <message>
        <source>A, P, L, Shift+R, S, I over 3D</source>
        <translation>A, P, L, Shift+R, S, I über 3D</translation>
    </message>
    <message>
        <source>Look from anterior, posterior, left, right, ...</source>
        <translation>Blick von anterior, posterior, links, rechts, ...</translation>
    </message>
</context>
<context>
    <name>TriangleMeasure</name>
    <message>
        <source>2 * inradius / circumradius; 1 is equilateral</source>
        <translation>2 * Inkreisradius / Umkreisradius; 1 ist gleichseitig</translation>
    </message>
    <message>
        <source>60 is equilateral</source>
        <translation>60 ist gleichseitig</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Gap outside</source>
        <translation>Spalt außen</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Radius ratio</source>
        <translation>Radienverhältnis</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Size gradation</source>
        <translation>Größenabstufung</translation>
    </message>
    <message>
        <source>Skewness</source>
        <translation>Schiefe</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Valence, off 6</source>
        <translation>Valenz, Abw. von 6</translation>
    </message>
    <message>
        <source>distance of the vertices around from a smooth fit</source>
        <translation>Abstand der Knoten ringsum von einer glatten Anpassung</translation>
    </message>
    <message>
        <source>longest edge / (inradius * 12^0.5); 1 is equilateral</source>
        <translation>längste Kante / (Inkreisradius * 12^0.5); 1 ist gleichseitig</translation>
    </message>
    <message>
        <source>mean edge over that of the neighbour that differs most, the larger over the smaller</source>
        <translation>mittlere Kante zu der des Nachbarn, der am stärksten abweicht, die größere zur kleineren</translation>
    </message>
    <message>
        <source>of the angles; 0 is equilateral, 1 has no area</source>
        <translation>der Winkel; 0 ist gleichseitig, 1 hat keine Fläche</translation>
    </message>
    <message>
        <source>straight inwards to the other side of the vessel</source>
        <translation>geradewegs nach innen zur anderen Seite des Gefäßes</translation>
    </message>
    <message>
        <source>straight outwards to the wall again, in edges of the triangle</source>
        <translation>geradewegs nach außen bis wieder zur Wand, in Kanten des Dreiecks</translation>
    </message>
    <message>
        <source>triangles at a vertex against the 6 of an even mesh, at the worst corner</source>
        <translation>Dreiecke an einem Knoten gegenüber den 6 eines gleichmäßigen Netzes, an der schlechtesten Ecke</translation>
    </message>
</context>
<context>
    <name>WindowPreset</name>
    <message>
        <source>From the file</source>
        <translation>Aus der Datei</translation>
    </message>
    <message>
        <source>1st to 99.8th percentile</source>
        <translation>1. bis 99,8. Perzentil</translation>
    </message>
    <message>
        <source>CT angiography</source>
        <translation>CT-Angiographie</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Hirn</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
</context>
<context>
    <name>angiomesh::Banner</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseCorrections</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add to the edge</source>
        <translation>Bis zum Rand hinzufügen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Erase to the edge</source>
        <translation>Bis zum Rand löschen</translation>
    </message>
    <message>
        <source>Join two ends</source>
        <translation>Zwei Enden verbinden</translation>
    </message>
    <message>
        <source>Separate two vessels</source>
        <translation>Zwei Gefäße trennen</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Abschneiden</translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation>Loch füllen</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Schleife öffnen</translation>
    </message>
    <message>
        <source>remove a correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: nothing changed.</source>
        <translation>%1: Es hat sich nichts geändert.</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseDialogs</name>
    <message>
        <source>1 change</source>
        <translation>1 Änderung</translation>
    </message>
    <message>
        <source>%1 changes</source>
        <translation>%1 Änderungen</translation>
    </message>
    <message>
        <source>%1 of the case %2</source>
        <translation>%1 am Fall %2</translation>
    </message>
    <message>
        <source>%1 of a case that was never saved, the last one on %2</source>
        <translation>%1 an einem nie gespeicherten Fall, die letzte am %2</translation>
    </message>
    <message>
        <source>%1 of %2, which was never saved, the last one on %3</source>
        <translation>%1 an %2, nie gespeichert, die letzte am %3</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseDocument</name>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>add a seed</source>
        <translation>Saatpunkt setzen</translation>
    </message>
    <message>
        <source>remove a seed</source>
        <translation>Saatpunkt entfernen</translation>
    </message>
    <message>
        <source>draw the region of interest</source>
        <translation>ROI ziehen</translation>
    </message>
    <message>
        <source>clear the region of interest</source>
        <translation>ROI löschen</translation>
    </message>
    <message>
        <source>move a seed</source>
        <translation>Saatpunkt verschieben</translation>
    </message>
    <message>
        <source>this vessel only</source>
        <translation>nur dieses Gefäß</translation>
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
        <translation>%1-Serie aus %2 Dateien</translation>
    </message>
    <message>
        <source>The case %1 is open already.</source>
        <translation>Der Fall %1 ist schon offen.</translation>
    </message>
    <message>
        <source>Cannot open: %1</source>
        <translation>Öffnen nicht möglich: %1</translation>
    </message>
    <message>
        <source>Begins with the preset %1.</source>
        <translation>Beginnt mit der Vorgabe %1.</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>wiederhergestellt</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Opened %1: %2%3.</source>
        <translation>%1 geöffnet: %2%3.</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>Taken as a segmentation: its label %1%2, %3 voxels, is the vessel. For a scan choose another segmentation.method.</source>
        <translation>Als Segmentierung übernommen: Ihr Label %1%2 mit %3 Voxeln ist das Gefäß. Für eine Aufnahme eine andere segmentation.method wählen.</translation>
    </message>
    <message>
        <source>Restored a change that had not been saved.</source>
        <translation>Eine nicht gespeicherte Änderung wiederhergestellt.</translation>
    </message>
    <message>
        <source>Restored %1 changes that had not been saved.</source>
        <translation>%1 nicht gespeicherte Änderungen wiederhergestellt.</translation>
    </message>
    <message>
        <source>Saved the case %1.</source>
        <translation>Fall %1 gespeichert.</translation>
    </message>
    <message>
        <source>Cannot save the case: %1</source>
        <translation>Der Fall lässt sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>Edits are not kept for a restore, save the case elsewhere: %1</source>
        <translation>Änderungen lassen sich nicht für eine Wiederherstellung sichern, den Fall anderswo speichern: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseMeasures</name>
    <message>
        <source>Run to Evolve first: there is no wall to measure yet.</source>
        <translation>Zuerst bis Evolution rechnen: Noch gibt es keine Wand zu messen.</translation>
    </message>
    <message>
        <source>The case holds %1 measurements, which is the most: delete some first.</source>
        <translation>Der Fall enthält %1 Messungen, mehr sind nicht möglich: zuerst einige löschen.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messung läuft…</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>Erneut messen</translation>
    </message>
    <message>
        <source>Not measured: %1</source>
        <translation>Nicht gemessen: %1</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>A measurement needs a name.</source>
        <translation>Eine Messung braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is another measurement %1.</source>
        <translation>Es gibt schon eine Messung %1.</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Cannot export: %1</source>
        <translation>Exportieren nicht möglich: %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 measurements.</source>
        <translation>%1 geschrieben: %2 Messungen.</translation>
    </message>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>proximal</source>
        <translation>proximal</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 verschieben</translation>
    </message>
</context>
<context>
    <name>angiomesh::CasePorts</name>
    <message>
        <source>The vessel is cut there already: run to make the cut.</source>
        <translation>Das Gefäß ist dort schon geschnitten: rechnen, um den Schnitt auszuführen.</translation>
    </message>
    <message>
        <source>cut across %1</source>
        <translation>%1 quer schneiden</translation>
    </message>
    <message>
        <source>import ports</source>
        <translation>Öffnungen importieren</translation>
    </message>
    <message>
        <source>flip the cut %1</source>
        <translation>Schnitt %1 umdrehen</translation>
    </message>
    <message>
        <source>delete the cut %1</source>
        <translation>Schnitt %1 löschen</translation>
    </message>
    <message>
        <source>rename the cut %1 to %2</source>
        <translation>Schnitt %1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>name the opening %1 %2</source>
        <translation>Öffnung %1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>tilt the cut %1</source>
        <translation>Schnitt %1 kippen</translation>
    </message>
    <message>
        <source>move the cut %1</source>
        <translation>Schnitt %1 verschieben</translation>
    </message>
    <message>
        <source>There are no vessels to cut yet: run to Evolve first.</source>
        <translation>Noch gibt es keine Gefäße zu schneiden: zuerst bis Evolution rechnen.</translation>
    </message>
    <message>
        <source>add the cut %1</source>
        <translation>Schnitt %1 setzen</translation>
    </message>
    <message>
        <source>No end was cut: no vessel ends in the volume without a cut already.</source>
        <translation>Kein Ende geschnitten: Kein Gefäß endet ohne Schnitt im Volumen.</translation>
    </message>
    <message>
        <source>Nothing was cut: at the volume&apos;s border no vessel is sliced any more.</source>
        <translation>Nichts geschnitten: Am Volumenrand wird kein Gefäß mehr schräg angeschnitten.</translation>
    </message>
    <message>
        <source>%1 places were not cut: the log says why.</source>
        <translation>%1 Stellen wurden nicht geschnitten: Das Protokoll nennt den Grund.</translation>
    </message>
    <message>
        <source>cut all ends</source>
        <translation>Alle Enden schneiden</translation>
    </message>
    <message>
        <source>cut all across</source>
        <translation>Alle quer schneiden</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseReviewModel</name>
    <message>
        <source>accept the segmentation</source>
        <translation>Segmentierung annehmen</translation>
    </message>
    <message>
        <source>reject the segmentation</source>
        <translation>Segmentierung ablehnen</translation>
    </message>
    <message>
        <source>take the verdict back</source>
        <translation>Urteil zurücknehmen</translation>
    </message>
    <message>
        <source>score the segmentation</source>
        <translation>Segmentierung bewerten</translation>
    </message>
    <message>
        <source>add a remark</source>
        <translation>Anmerkung hinzufügen</translation>
    </message>
    <message>
        <source>edit a remark</source>
        <translation>Anmerkung bearbeiten</translation>
    </message>
    <message>
        <source>remove a remark</source>
        <translation>Anmerkung entfernen</translation>
    </message>
    <message>
        <source>look at doubtful places</source>
        <translation>Fragliche Stellen ansehen</translation>
    </message>
    <message>
        <source>No place of this segmentation is doubtful.</source>
        <translation>Keine Stelle dieser Segmentierung ist fraglich.</translation>
    </message>
</context>
<context>
    <name>angiomesh::CaseSensitivity</name>
    <message>
        <source>Open a scan first.</source>
        <translation>Öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>The wall of a segmentation depends on no such parameter.</source>
        <translation>Die Wand einer Segmentierung hängt von keinem solchen Parameter ab.</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Largest move of the wall, mm</source>
        <translation>Größte Verschiebung der Wand, mm</translation>
    </message>
    <message>
        <source>Move outwards, mm: %1</source>
        <translation>Verschiebung nach außen, mm: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::CentralArea</name>
    <message>
        <source>Open file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Open DICOM folder…</source>
        <translation>DICOM-Ordner öffnen…</translation>
    </message>
    <message>
        <source>Try the sample</source>
        <translation>Beispiel ausprobieren</translation>
    </message>
</context>
<context>
    <name>angiomesh::ComponentTable</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of the centre lines, all branches, mm</source>
        <translation>Der Mittellinien, alle Äste, mm</translation>
    </message>
    <message>
        <source>Mean radius, mm</source>
        <translation>Mittlerer Radius, mm</translation>
    </message>
    <message>
        <source>Left out by which parts are kept, or by the least volume</source>
        <translation>Weggelassen durch die Wahl der Teile oder das Mindestvolumen</translation>
    </message>
    <message>
        <source>Ticked off: not meshed</source>
        <translation>Abgewählt: nicht vernetzt</translation>
    </message>
    <message>
        <source>Parts: %1 (the largest %2 are listed)</source>
        <translation>Teile: %1 (die größten %2 sind aufgeführt)</translation>
    </message>
    <message>
        <source>Parts: %1</source>
        <translation>Teile: %1</translation>
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
        <translation>Linie: wie weit sich die Front je Iteration bewegt, Voxel; Punkte: ihre Änderung bei den Prüfungen; gestrichelt: die Toleranz. Eine Marke unten anklicken, um die Front von damals zu sehen.</translation>
    </message>
    <message>
        <source>Change over iterations</source>
        <translation>Änderung über Iterationen</translation>
    </message>
    <message>
        <source>Iteration %1</source>
        <translation>Iteration %1</translation>
    </message>
    <message>
        <source>, moves %1 voxel</source>
        <translation>, bewegt sich %1 Voxel</translation>
    </message>
    <message>
        <source>, change %1</source>
        <translation>, Änderung %1</translation>
    </message>
    <message>
        <source>No evolution yet</source>
        <translation>Noch keine Evolution</translation>
    </message>
</context>
<context>
    <name>angiomesh::CorrectMenu</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Paint what is missing of a vessel</source>
        <translation>Malen, was an einem Gefäß fehlt</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Paint over what is no vessel</source>
        <translation>Übermalen, was kein Gefäß ist</translation>
    </message>
    <message>
        <source>Join two ends</source>
        <translation>Zwei Enden verbinden</translation>
    </message>
    <message>
        <source>Click the two ends of a gap: they are joined along the vessel between them</source>
        <translation>Beide Enden einer Lücke anklicken: sie werden entlang des Gefäßes dazwischen verbunden</translation>
    </message>
    <message>
        <source>Separate two vessels</source>
        <translation>Zwei Gefäße trennen</translation>
    </message>
    <message>
        <source>Click each of two vessels that touch, beside the place</source>
        <translation>Beide Gefäße, die sich berühren, neben der Stelle anklicken</translation>
    </message>
    <message>
        <source>Cut off the smaller side</source>
        <translation>Kleinere Seite abschneiden</translation>
    </message>
    <message>
        <source>Ends the vessel at the crosshair; no port is made</source>
        <translation>Beendet das Gefäß am Fadenkreuz; es entsteht keine Öffnung</translation>
    </message>
    <message>
        <source>Fill the hole</source>
        <translation>Loch füllen</translation>
    </message>
    <message>
        <source>Fills the cavity, or the hole through a vessel, at the crosshair</source>
        <translation>Füllt den Hohlraum oder das Loch durch ein Gefäß am Fadenkreuz</translation>
    </message>
    <message>
        <source>Open the loop</source>
        <translation>Schleife öffnen</translation>
    </message>
    <message>
        <source>Cuts the loop whose thinnest place is nearest to the crosshair</source>
        <translation>Durchtrennt die Schleife, deren dünnste Stelle dem Fadenkreuz am nächsten ist</translation>
    </message>
    <message>
        <source>C&amp;orrect</source>
        <translation>&amp;Korrigieren</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Größerer Pinsel</translation>
    </message>
    <message>
        <source>Stop at the edge in the image</source>
        <translation>Am Rand im Bild anhalten</translation>
    </message>
    <message>
        <source>The brush adds only what is as bright as a vessel, and erases only what is not</source>
        <translation>Der Pinsel fügt nur hinzu, was so hell wie ein Gefäß ist, und löscht nur, was es nicht ist</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Korrigieren</translation>
    </message>
    <message>
        <source>Correct here</source>
        <translation>Hier korrigieren</translation>
    </message>
    <message>
        <source>Add with the brush</source>
        <translation>Mit dem Pinsel hinzufügen</translation>
    </message>
    <message>
        <source>Erase with the brush</source>
        <translation>Mit dem Pinsel löschen</translation>
    </message>
    <message>
        <source>%1, from here</source>
        <translation>%1, von hier</translation>
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
        <translation>%1 (ausgelassen)</translation>
    </message>
    <message>
        <source>%1 (%2 voxels)</source>
        <translation>%1 (%2 Voxel)</translation>
    </message>
    <message>
        <source>Brush: </source>
        <translation>Pinsel: </translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Radius des Pinsels ([ und ])</translation>
    </message>
    <message>
        <source>To the edge</source>
        <translation>Bis zum Rand</translation>
    </message>
    <message>
        <source>The brush adds only what is as bright as a vessel, and erases only what is not</source>
        <translation>Der Pinsel fügt nur hinzu, was so hell wie ein Gefäß ist, und löscht nur, was es nicht ist</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
</context>
<context>
    <name>angiomesh::EvolutionControls</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>%1 iterations, then pause again</source>
        <translation>%1 Iterationen, dann wieder Pause</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Takes the surface as it stands</source>
        <translation>Nimmt die Oberfläche, wie sie ist</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>No iterations yet</source>
        <translation>Noch keine Iterationen</translation>
    </message>
    <message>
        <source>Iteration %1</source>
        <translation>Iteration %1</translation>
    </message>
    <message>
        <source>Iteration %1, change %2</source>
        <translation>Iteration %1, Änderung %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::EvolutionPanel</name>
    <message>
        <source>Use this front</source>
        <translation>Diese Front nehmen</translation>
    </message>
    <message>
        <source>Ends the evolution at this iteration (levelset.stopAfter)</source>
        <translation>Beendet die Evolution bei dieser Iteration (levelset.stopAfter)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Shows the last front, or the result, again</source>
        <translation>Zeigt wieder die letzte Front oder das Ergebnis</translation>
    </message>
    <message>
        <source>stop after iteration %1</source>
        <translation>Nach Iteration %1 anhalten</translation>
    </message>
</context>
<context>
    <name>angiomesh::ExportDialog</name>
    <message>
        <source>A DICOM segmentation (SEG): viewers lay it on the scan. It has the UIDs of the scan&apos;s images and of their frame of reference.</source>
        <translation>Eine DICOM-Segmentierung (SEG): Betrachter legen sie auf die Aufnahme. Sie hat die UIDs der Bilder der Aufnahme und ihres Bezugssystems.</translation>
    </message>
    <message>
        <source>1 in the voxels of the scan whose centre lies in the vessels, 0 in all others: it lies on the scan in any program.</source>
        <translation>1 in den Voxeln der Aufnahme, deren Mitte in den Gefäßen liegt, 0 in allen anderen: Sie liegt in jedem Programm auf der Aufnahme.</translation>
    </message>
    <message>
        <source>A folder with the surface in metres, a patch for each port, and what OpenFOAM needs to fill it.</source>
        <translation>Ein Ordner mit der Oberfläche in Metern, einem Patch je Öffnung und allem, was OpenFOAM zum Füllen braucht.</translation>
    </message>
    <message>
        <source>DICOM segmentation (.dcm)</source>
        <translation>DICOM-Segmentierung (.dcm)</translation>
    </message>
    <message>
        <source>%1, binary</source>
        <translation>%1, binär</translation>
    </message>
    <message>
        <source>%1, ASCII</source>
        <translation>%1, ASCII</translation>
    </message>
    <message>
        <source>OpenFOAM case</source>
        <translation>OpenFOAM-Fall</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Mesh, %1</source>
        <translation>Netz, %1</translation>
    </message>
    <message>
        <source>Mask of the vessels</source>
        <translation>Maske der Gefäße</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Koordinaten</translation>
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
        <translation>Größe des Ergebnisses</translation>
    </message>
    <message>
        <source>Normals of the vertices</source>
        <translation>Normalen der Knoten</translation>
    </message>
    <message>
        <source>Quality of the triangles (radius ratio)</source>
        <translation>Qualität der Dreiecke (Radienverhältnis)</translation>
    </message>
    <message>
        <source>Write NAME.report.json beside it</source>
        <translation>Dazu NAME.report.json schreiben</translation>
    </message>
    <message>
        <source>Write NAME.ports.json beside it: where the ports lie</source>
        <translation>Dazu NAME.ports.json schreiben: wo die Öffnungen liegen</translation>
    </message>
    <message>
        <source>Write each patch to a file of its own, too</source>
        <translation>Auch jeden Patch in eine eigene Datei schreiben</translation>
    </message>
    <message>
        <source>With the patient&apos;s identity</source>
        <translation>Mit Identität des Patienten</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>⚠ The file will name the patient and the study, as the images of the scan do: a PACS files it with them.</source>
        <translation>⚠ Die Datei wird Patient und Studie nennen, wie die Bilder der Aufnahme: Ein PACS ordnet sie diesen zu.</translation>
    </message>
    <message>
        <source>Patient and study are left empty: tick the identity for a PACS to file it with the scan.</source>
        <translation>Patient und Studie bleiben leer: Die Identität ankreuzen, damit ein PACS die Datei der Aufnahme zuordnet.</translation>
    </message>
    <message>
        <source>The segmentation in work is not done: the one before is exported.</source>
        <translation>Die laufende Segmentierung ist nicht fertig: Die vorige wird exportiert.</translation>
    </message>
    <message>
        <source>The segmentation belongs to earlier parameters: run again for the present ones.</source>
        <translation>Die Segmentierung gehört zu früheren Parametern: für die jetzigen neu rechnen.</translation>
    </message>
    <message>
        <source>The mesh belongs to earlier parameters: run again for the present ones.</source>
        <translation>Das Netz gehört zu früheren Parametern: für die jetzigen neu rechnen.</translation>
    </message>
    <message>
        <source>⚠ It loses the names of the %1 ports: STL, ASCII has them.</source>
        <translation>⚠ Die Namen der %1 Öffnungen gehen verloren: STL, ASCII enthält sie.</translation>
    </message>
    <message>
        <source>⚠ This mesh cuts itself or is no manifold: a flow solver will refuse it. Marching cubes of the same level set may do.</source>
        <translation>⚠ Dieses Netz schneidet sich selbst oder ist nicht manifold: Ein Strömungslöser wird es ablehnen. Marching Cubes aus demselben Level-Set kann gehen.</translation>
    </message>
    <message>
        <source>⚠ This mesh has no ports: nothing could flow in or out.</source>
        <translation>⚠ Dieses Netz hat keine Öffnungen: Nichts könnte ein- oder ausströmen.</translation>
    </message>
    <message>
        <source>⚠ The mesh is not closed: choose surface.border = cap.</source>
        <translation>⚠ Das Netz ist nicht geschlossen: surface.border = cap wählen.</translation>
    </message>
    <message>
        <source>⚠ The surface has %1 parts that are not connected, and OpenFOAM fills one: tick the others off, or set segmentation.keep.</source>
        <translation>⚠ Die Oberfläche hat %1 unverbundene Teile, und OpenFOAM füllt nur einen: die übrigen abwählen oder segmentation.keep setzen.</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
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
        <translation>Diese Oberfläche ist für einen Löser nicht tauglich: %1. Die Stelle im Bild ansehen und stärker glätten oder eine andere Oberflächenmethode wählen.</translation>
    </message>
    <message>
        <source>This segmentation belongs to earlier parameters: run again for the present ones.</source>
        <translation>Diese Segmentierung gehört zu früheren Parametern: für die jetzigen neu rechnen.</translation>
    </message>
    <message>
        <source>These ports belong to earlier parameters: run again for the present ones.</source>
        <translation>Diese Öffnungen gehören zu früheren Parametern: für die jetzigen neu rechnen.</translation>
    </message>
    <message>
        <source>An export is being written: try again when it is done.</source>
        <translation>Ein Export wird gerade geschrieben: danach erneut versuchen.</translation>
    </message>
    <message>
        <source>There is no segmentation to export: run the pipeline first.</source>
        <translation>Es gibt keine Segmentierung zu exportieren: zuerst die Pipeline rechnen.</translation>
    </message>
    <message>
        <source>There is no mesh to export: run the pipeline first.</source>
        <translation>Es gibt kein Netz zu exportieren: zuerst die Pipeline rechnen.</translation>
    </message>
    <message>
        <source>Cannot export: %1</source>
        <translation>Exportieren nicht möglich: %1</translation>
    </message>
    <message>
        <source>Wrote %1: %2 openings.</source>
        <translation>%1 geschrieben: %2 Öffnungen.</translation>
    </message>
    <message>
        <source>Wrote the OpenFOAM case %1. Its script Allrun fills it.</source>
        <translation>OpenFOAM-Fall %1 geschrieben. Sein Skript Allrun füllt ihn.</translation>
    </message>
    <message>
        <source>Wrote %1. Read back: a mask of %2 voxels (%3 ml) in %4.</source>
        <translation>%1 geschrieben. Zurückgelesen: Maske mit %2 Voxeln (%3 ml) in %4.</translation>
    </message>
    <message>
        <source>its report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>its ports</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <source>%1 files of single patches</source>
        <translation>%1 Dateien einzelner Patches</translation>
    </message>
    <message>
        <source>Wrote %1%2. Read back: %3 vertices, %4 triangles, %5, %6 in %7.</source>
        <translation>%1%2 geschrieben. Zurückgelesen: %3 Knoten, %4 Dreiecke, %5, %6 in %7.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>nicht geschlossen</translation>
    </message>
</context>
<context>
    <name>angiomesh::FieldEditor</name>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Larger: %1.</source>
        <translation>Größer: %1.</translation>
    </message>
    <message>
        <source>Has no effect now: %1.</source>
        <translation>Derzeit ohne Wirkung: %1.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>Punkte: %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Changed. Back to %1, as in the preset %2.</source>
        <translation>Geändert. Zurück zu %1, wie in der Vorgabe %2.</translation>
    </message>
</context>
<context>
    <name>angiomesh::GateList</name>
    <message>
        <source>Smaller ρ (× 0.7)</source>
        <translation>ρ kleiner (× 0.7)</translation>
    </message>
    <message>
        <source>Sets surface.rho: more triangles, which follow the wall more closely</source>
        <translation>Setzt surface.rho: mehr Dreiecke, die der Wand genauer folgen</translation>
    </message>
    <message>
        <source>Keep the largest part only</source>
        <translation>Nur den größten Teil behalten</translation>
    </message>
    <message>
        <source>Sets segmentation.keep; single parts are unticked in the table of parts</source>
        <translation>Setzt segmentation.keep; einzelne Teile werden in der Tabelle der Teile abgewählt</translation>
    </message>
    <message>
        <source>Close the ends</source>
        <translation>Enden schließen</translation>
    </message>
    <message>
        <source>Sets surface.border to cap</source>
        <translation>Setzt surface.border auf cap</translation>
    </message>
    <message>
        <source>Use the advancing front</source>
        <translation>Vorrückende Front nehmen</translation>
    </message>
    <message>
        <source>Sets surface.method to advancing-front</source>
        <translation>Setzt surface.method auf advancing-front</translation>
    </message>
    <message>
        <source>Close thin loops</source>
        <translation>Dünne Schleifen schließen</translation>
    </message>
    <message>
        <source>Sets wall.smooth: holes and handles that noise explains are closed</source>
        <translation>Setzt wall.smooth: Löcher und Henkel, die sich durch Rauschen erklären, werden geschlossen</translation>
    </message>
    <message>
        <source>A parameter has changed: run again.</source>
        <translation>Ein Parameter ist geändert: neu rechnen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: not measured yet</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: noch nicht gemessen</translation>
    </message>
    <message>
        <source>Loops: %1. Vessels may join in rings; or two that touch have grown together. A smooth wall closes thin loops, and Cut vessel parts two vessels.</source>
        <translation>Schleifen: %1. Gefäße können Ringe bilden; oder zwei, die sich berühren, sind verwachsen. Eine glatte Wand schließt dünne Schleifen, und das Werkzeug Schneiden trennt zwei Gefäße.</translation>
    </message>
</context>
<context>
    <name>angiomesh::Guide</name>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>In allen Seiten suchen</translation>
    </message>
    <message>
        <source>Key or mouse</source>
        <translation>Taste oder Maus</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Wirkung</translation>
    </message>
</context>
<context>
    <name>angiomesh::HistogramWidget</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>No mesh yet</source>
        <translation>Noch kein Netz</translation>
    </message>
    <message>
        <source>%1 (% of triangles)</source>
        <translation>%1 (% der Dreiecke)</translation>
    </message>
</context>
<context>
    <name>angiomesh::InspectorPanel</name>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Mesh shown</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>einfarbig</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>A click on a bar lights its triangles up in 3D; drag for more bars</source>
        <translation>Ein Klick auf einen Balken hebt seine Dreiecke in 3D hervor; für mehrere Balken ziehen</translation>
    </message>
    <message>
        <source>Worst of the mesh shown</source>
        <translation>Schlechteste Stellen des Netzes</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>◐ %1 belongs to earlier parameters: run again.</source>
        <translation>◐ %1 gehört zu früheren Parametern: neu rechnen.</translation>
    </message>
    <message>
        <source>Quality is not measured yet: run to the end.</source>
        <translation>Die Qualität ist noch nicht gemessen: bis zum Ende rechnen.</translation>
    </message>
    <message>
        <source>No mesh yet: open a volume and press Run.</source>
        <translation>Noch kein Netz: ein Volumen öffnen und auf Rechnen klicken.</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>open, rims: %1</source>
        <translation>offen, Ränder: %1</translation>
    </message>
    <message>
        <source>manifold</source>
        <translation>manifold</translation>
    </message>
    <message>
        <source>not manifold: a solver refuses it</source>
        <translation>nicht manifold: ein Löser lehnt es ab</translation>
    </message>
    <message>
        <source>no self-intersections</source>
        <translation>keine Selbstschnitte</translation>
    </message>
    <message>
        <source>%1 self-intersections</source>
        <translation>%1 Selbstschnitte</translation>
    </message>
    <message>
        <source>no degenerate triangles</source>
        <translation>keine entarteten Dreiecke</translation>
    </message>
    <message>
        <source>%1 degenerate triangles</source>
        <translation>%1 entartete Dreiecke</translation>
    </message>
    <message>
        <source>%1 parts not verified</source>
        <translation>%1 Teile nicht geprüft</translation>
    </message>
    <message>
        <source>Compares a mesh from a file (PLY, STL, OBJ, OFF, VTP, VTK) with these</source>
        <translation>Vergleicht ein Netz aus einer Datei (PLY, STL, OBJ, OFF, VTP, VTK) mit diesen</translation>
    </message>
    <message>
        <source>Beside it</source>
        <translation>Daneben</translation>
    </message>
    <message>
        <source>Mesh from a file</source>
        <translation>Netz aus einer Datei</translation>
    </message>
</context>
<context>
    <name>angiomesh::LabelDialog</name>
    <message>
        <source>Choose a label</source>
        <translation>Label wählen</translation>
    </message>
    <message>
        <source>This is a segmentation with %1 labels. Which one is the vessel?</source>
        <translation>Dies ist eine Segmentierung mit %1 Labels. Welches ist das Gefäß?</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Volume, ml</source>
        <translation>Volumen, ml</translation>
    </message>
    <message>
        <source>Open the label</source>
        <translation>Label öffnen</translation>
    </message>
    <message>
        <source>It is a scan</source>
        <translation>Ist eine Aufnahme</translation>
    </message>
</context>
<context>
    <name>angiomesh::LivePreview</name>
    <message>
        <source>open a scan first</source>
        <translation>erst einen Scan öffnen</translation>
    </message>
    <message>
        <source>a run is on</source>
        <translation>es wird gerechnet</translation>
    </message>
    <message>
        <source>evolving…</source>
        <translation>entwickelt sich …</translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation>in %1 s</translation>
    </message>
    <message>
        <source>level set only</source>
        <translation>nur für Level-Set</translation>
    </message>
    <message>
        <source>run once first</source>
        <translation>erst einmal rechnen</translation>
    </message>
    <message>
        <source>run anew first</source>
        <translation>erst neu rechnen</translation>
    </message>
    <message>
        <source>move a slider below</source>
        <translation>unten Regler bewegen</translation>
    </message>
</context>
<context>
    <name>angiomesh::LogPanel</name>
    <message>
        <source>Warning: </source>
        <translation>Warnung: </translation>
    </message>
    <message>
        <source>Error: </source>
        <translation>Fehler: </translation>
    </message>
</context>
<context>
    <name>angiomesh::MainWindow</name>
    <message>
        <source>Pipeline</source>
        <translation>Pipeline</translation>
    </message>
    <message>
        <source>Mesh inspector</source>
        <translation>Netzinspektor</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>Why here?</source>
        <translation>Warum hier?</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Remove all seeds by hand</source>
        <translation>Alle eigenen Saatpunkte entfernen</translation>
    </message>
    <message>
        <source>Clear region of interest</source>
        <translation>ROI löschen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>About Angiomesh</source>
        <translation>Über Angiomesh</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open folder or case…</source>
        <translation>Ordner oder Fall öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save case as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
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
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>%1: iteration %2</source>
        <translation>%1: Iteration %2</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>Turntable: picture %1 of %2</source>
        <translation>Rundumansicht: Bild %1 von %2</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Patient of this scan…</source>
        <translation>Patient dieser Aufnahme…</translation>
    </message>
    <message>
        <source>Compare with a mesh…</source>
        <translation>Mit einem Netz vergleichen…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Report on the mesh…</source>
        <translation>Bericht über das Netz…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Diese vergessen</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeasureMenu</name>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Diameter along a branch</source>
        <translation>Durchmesser entlang eines Astes</translation>
    </message>
    <message>
        <source>Stenosis</source>
        <translation>Stenose</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Erneut messen</translation>
    </message>
    <message>
        <source>At the same places, on the wall that is shown</source>
        <translation>An denselben Stellen, auf der gezeigten Wand</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>Als CSV exportieren…</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>Measure here</source>
        <translation>Hier messen</translation>
    </message>
    <message>
        <source>%1 from here</source>
        <translation>%1 ab hier</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeasurePanel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Nothing is measured: choose a tool of the menu Measure.</source>
        <translation>Nichts gemessen: ein Werkzeug aus dem Menü Messen wählen.</translation>
    </message>
    <message>
        <source>⚠ of earlier parameters</source>
        <translation>⚠ von früheren Parametern</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshChooser</name>
    <message>
        <source>The mesh in this view</source>
        <translation>Das Netz in dieser Ansicht</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Linked</source>
        <translation>Gekoppelt</translation>
    </message>
    <message>
        <source>Shows another mesh beside this one; drag the bar between them</source>
        <translation>Zeigt ein anderes Netz neben diesem; der Balken dazwischen lässt sich ziehen</translation>
    </message>
    <message>
        <source>Both views turn, move and zoom as one</source>
        <translation>Beide Ansichten drehen, verschieben und vergrößern sich gemeinsam</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshFile</name>
    <message>
        <source>Cannot compare with this mesh: %1</source>
        <translation>Vergleich mit diesem Netz nicht möglich: %1</translation>
    </message>
    <message>
        <source>%1: %2 triangles, compared with the meshes of the case.</source>
        <translation>%1: %2 Dreiecke, mit den Netzen des Falls verglichen.</translation>
    </message>
</context>
<context>
    <name>angiomesh::MeshReport</name>
    <message>
        <source>A report is being written: try again when it is done.</source>
        <translation>Ein Bericht wird gerade geschrieben: danach erneut versuchen.</translation>
    </message>
    <message>
        <source>There is no mesh to report on: run the pipeline first.</source>
        <translation>Es gibt kein Netz für einen Bericht: zuerst die Pipeline rechnen.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>This pane was never drawn.</source>
        <translation>Diese Ansicht wurde nie gezeichnet.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1, through the crosshair</source>
        <translation>%1, durch das Fadenkreuz</translation>
    </message>
    <message>
        <source>Projection of the image, as the 3D pane looks</source>
        <translation>Projektion des Bildes, in der Richtung der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Surface, from the same side</source>
        <translation>Oberfläche, von derselben Seite</translation>
    </message>
    <message>
        <source>Surface, turned by %1°</source>
        <translation>Oberfläche, um %1° gedreht</translation>
    </message>
    <message>
        <source>Per cent of the triangles, and in bands</source>
        <translation>Prozent der Dreiecke, und in Bereichen</translation>
    </message>
    <message>
        <source>Cannot write the report: %1</source>
        <translation>Der Bericht lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>Wrote the report %1.</source>
        <translation>Bericht %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PaneMenu</name>
    <message>
        <source>Show hidden parts</source>
        <translation>Verborgene Teile zeigen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Hide this part</source>
        <translation>Diesen Teil verbergen</translation>
    </message>
    <message>
        <source>Keep only this part</source>
        <translation>Nur diesen Teil behalten</translation>
    </message>
    <message>
        <source>Ticks all other parts off</source>
        <translation>Wählt alle anderen Teile ab</translation>
    </message>
    <message>
        <source>Remove this part</source>
        <translation>Diesen Teil entfernen</translation>
    </message>
    <message>
        <source>Ticks it off</source>
        <translation>Wählt ihn ab</translation>
    </message>
    <message>
        <source>Slab of this pane</source>
        <translation>Slab dieser Ansicht</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
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
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The same in all panes</source>
        <translation>In allen Ansichten gleich</translation>
    </message>
</context>
<context>
    <name>angiomesh::PaneTools</name>
    <message>
        <source>Overlay</source>
        <translation>Overlay</translation>
    </message>
    <message>
        <source>Slices in 3D</source>
        <translation>Schichten in 3D</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Slice planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Along the patient&apos;s axes</source>
        <translation>Entlang der Patientenachsen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Turn back</source>
        <translation>Zurückdrehen</translation>
    </message>
    <message>
        <source>  Overlay </source>
        <translation>  Overlay </translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Opacity of the overlay</source>
        <translation>Deckkraft des Overlays</translation>
    </message>
</context>
<context>
    <name>angiomesh::PatientIdentity</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>Patienten-ID</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Geboren</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Studiendatum</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation>Accession-Nummer</translation>
    </message>
    <message>
        <source>Patient of this scan</source>
        <translation>Patient dieser Aufnahme</translation>
    </message>
    <message>
        <source>Read from the files now. Angiomesh keeps none of it.</source>
        <translation>Eben aus den Dateien gelesen. Angiomesh behält nichts davon.</translation>
    </message>
    <message>
        <source>Cannot read the patient&apos;s identity: %1</source>
        <translation>Die Identität des Patienten lässt sich nicht lesen: %1</translation>
    </message>
</context>
<context>
    <name>angiomesh::PictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>all panes</source>
        <translation>alle Ansichten</translation>
    </message>
    <message>
        <source>turntable of the 3D pane</source>
        <translation>Rundumansicht in 3D</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Bild von</translation>
    </message>
    <message>
        <source>as on the screen</source>
        <translation>wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>twice as large</source>
        <translation>doppelt so groß</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>%1, every %2°</source>
        <translation>%1, alle %2°</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>With the crosshair</source>
        <translation>Mit Fadenkreuz</translation>
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
        <translation>Bild speichern…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copied a picture of %1 × %2 pixels.</source>
        <translation>Bild mit %1 × %2 Pixeln kopiert.</translation>
    </message>
    <message>
        <source>Pictures are being written: try again when they are done.</source>
        <translation>Bilder werden gerade geschrieben: danach erneut versuchen.</translation>
    </message>
    <message>
        <source>Folders NAME-turntable (*)</source>
        <translation>Ordner NAME-turntable (*)</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Cannot save the picture: %1</source>
        <translation>Das Bild lässt sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>Saved %1, %2 × %3 pixels.</source>
        <translation>%1 gespeichert, %2 × %3 Pixel.</translation>
    </message>
    <message>
        <source>Gave up the turntable: nothing of it was kept.</source>
        <translation>Rundumansicht abgebrochen: Nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>Saved the %1 pictures of %2, %3 × %4 pixels.</source>
        <translation>Die %1 Bilder von %2 gespeichert, %3 × %4 Pixel.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PipelinePanel</name>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Runs the whole pipeline; what is fresh is not computed again</source>
        <translation>Rechnet die ganze Pipeline; was aktuell ist, wird nicht neu berechnet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>✕ %1 failed: %2</source>
        <translation>✕ %1 fehlgeschlagen: %2</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Tries what is changed below Seeds at once, in a box around the crosshair. The result stays as it is until you run.</source>
        <translation>Probiert Änderungen unterhalb der Saatpunkte sofort aus, in einem Kasten um das Fadenkreuz. Das Ergebnis bleibt, wie es ist, bis Sie rechnen.</translation>
    </message>
    <message>
        <source>Side of the box in voxels: a smaller one answers faster</source>
        <translation>Kantenlänge des Kastens in Voxeln: Ein kleinerer antwortet schneller</translation>
    </message>
    <message>
        <source>Save, remove, import and export presets</source>
        <translation>Vorgaben speichern, entfernen, einlesen und ausgeben</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, geändert</translation>
    </message>
</context>
<context>
    <name>angiomesh::PortMenu</name>
    <message>
        <source>P&amp;orts</source>
        <translation>Ö&amp;ffnungen</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Hier schneiden</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Cuts the vessel at the crosshair (Ctrl+K)</source>
        <translation>Schneidet das Gefäß am Fadenkreuz (Ctrl+K)</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Quer schneiden</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Ends the vessel across just inside an opening that slices it (Ctrl+Alt+K)</source>
        <translation>Beendet das Gefäß quer, knapp innerhalb einer Öffnung, die es schräg anschneidet (Ctrl+Alt+K)</translation>
    </message>
    <message>
        <source>Cut all ends…</source>
        <translation>Enden schneiden…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Cut all across</source>
        <translation>Alle quer</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+K</source>
        <translation>Ctrl+Alt+Shift+K</translation>
    </message>
    <message>
        <source>Ends all vessels across that the volume&apos;s border slices (Ctrl+Alt+Shift+K)</source>
        <translation>Beendet alle Gefäße quer, die der Volumenrand schräg anschneidet (Ctrl+Alt+Shift+K)</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Cuts away the other side (Ctrl+Shift+F)</source>
        <translation>Schneidet die andere Seite weg (Ctrl+Shift+F)</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Import ports…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>Export ports…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Why here?</source>
        <translation>Warum hier?</translation>
    </message>
    <message>
        <source>Cut all ends</source>
        <translation>Alle Enden schneiden</translation>
    </message>
    <message>
        <source>Each vessel that ends in the volume gets a cut, which can be edited.
How far before its tip, in radii of the vessel:</source>
        <translation>Jedes Gefäß, das im Volumen endet, erhält einen Schnitt, der bearbeitet werden kann.
Abstand vor der Spitze, in Radien des Gefäßes:</translation>
    </message>
    <message>
        <source>Ports (*.json)</source>
        <translation>Öffnungen (*.json)</translation>
    </message>
</context>
<context>
    <name>angiomesh::PortPanel</name>
    <message>
        <source>Port</source>
        <translation>Öffnung</translation>
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
        <translation>Status</translation>
    </message>
    <message>
        <source>Diameter of the circle of the same area</source>
        <translation>Durchmesser des flächengleichen Kreises</translation>
    </message>
    <message>
        <source>No ports: put the crosshair into a vessel and press Cut here, or right-click one.</source>
        <translation>Keine Öffnungen: das Fadenkreuz in ein Gefäß setzen und Hier schneiden drücken, oder ein Gefäß rechts anklicken.</translation>
    </message>
    <message>
        <source>Run to Evolve, then cut the vessels here.</source>
        <translation>Bis Evolution rechnen, dann die Gefäße hier schneiden.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetDialog</name>
    <message>
        <source>Save as a preset</source>
        <translation>Als Vorgabe speichern</translation>
    </message>
    <message>
        <source>All parameters are kept, but not seeds, region of interest, cuts and corrections: these belong to one scan. Do not write a patient&apos;s name.</source>
        <translation>Alle Parameter werden behalten, nicht aber Saatpunkte, ROI, Schnitte und Korrekturen: Sie gehören zu einer Aufnahme. Schreiben Sie keinen Patientennamen.</translation>
    </message>
    <message>
        <source>such as the scanner or the region</source>
        <translation>etwa das Gerät oder die Region</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is for</source>
        <translation>Wofür sie ist</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>It replaces the preset of this name.</source>
        <translation>Sie ersetzt die Vorgabe dieses Namens.</translation>
    </message>
    <message>
        <source>%1 comes with the program: choose another name.</source>
        <translation>%1 gehört zum Programm: Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Saved the preset %1.</source>
        <translation>Vorgabe %1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetMenu</name>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Save as a preset…</source>
        <translation>Als Vorgabe speichern…</translation>
    </message>
    <message>
        <source>Remove this preset…</source>
        <translation>Diese Vorgabe entfernen…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>Vorgabe einlesen…</translation>
    </message>
    <message>
        <source>Export this preset…</source>
        <translation>Diese Vorgabe ausgeben…</translation>
    </message>
    <message>
        <source>There is a preset %1 with these parameters.</source>
        <translation>Es gibt eine Vorgabe %1 mit diesen Parametern.</translation>
    </message>
    <message>
        <source>%1 (imported)</source>
        <translation>%1 (eingelesen)</translation>
    </message>
    <message>
        <source>Cannot import the preset: %1</source>
        <translation>Die Vorgabe kann nicht eingelesen werden: %1</translation>
    </message>
    <message>
        <source>Imported the preset %1.</source>
        <translation>Vorgabe %1 eingelesen.</translation>
    </message>
    <message>
        <source>Presets (*.preset.json *.json)</source>
        <translation>Vorgaben (*.preset.json *.json)</translation>
    </message>
    <message>
        <source>Cannot write the preset: %1</source>
        <translation>Die Vorgabe kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Wrote the preset %1: angiomesh-cli run SCAN --params %1 begins with it.</source>
        <translation>Vorgabe %1 geschrieben: angiomesh-cli run SCAN --params %1 beginnt mit ihr.</translation>
    </message>
    <message>
        <source>Removed the preset %1.</source>
        <translation>Vorgabe %1 entfernt.</translation>
    </message>
</context>
<context>
    <name>angiomesh::PresetShelf</name>
    <message>
        <source>preset %1</source>
        <translation>Vorgabe %1</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Eine Vorgabe braucht einen Namen.</translation>
    </message>
    <message>
        <source>The name is too long: at most %1 letters.</source>
        <translation>Der Name ist zu lang: höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>%1 comes with the program: choose another name.</source>
        <translation>%1 gehört zum Programm: Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ProfilePlot</name>
    <message>
        <source>Diameter along the centre line: of the circle as large as the section and, thin, the least one. A click goes there.</source>
        <translation>Durchmesser entlang der Mittellinie: des flächengleichen Kreises und, dünn, der kleinste. Ein Klick führt dorthin.</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Durchmesser, mm</translation>
    </message>
    <message>
        <source>along the centre line, mm</source>
        <translation>entlang der Mittellinie, mm</translation>
    </message>
</context>
<context>
    <name>angiomesh::QualityGrid</name>
    <message>
        <source>The best of the meshes compared</source>
        <translation>Das beste der verglichenen Netze</translation>
    </message>
</context>
<context>
    <name>angiomesh::RecipeActions</name>
    <message>
        <source>Recipe…</source>
        <translation>Rezept…</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Als Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>Copy methods paragraph</source>
        <translation>Methodenabsatz kopieren</translation>
    </message>
    <message>
        <source>Recipes (*.recipe.json *.json)</source>
        <translation>Rezepte (*.recipe.json *.json)</translation>
    </message>
    <message>
        <source>Cannot write the recipe: %1</source>
        <translation>Das Rezept kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Wrote the recipe %1: angiomesh-cli run SCAN --recipe %1 makes the same mesh.</source>
        <translation>Rezept %1 geschrieben: angiomesh-cli run SCAN --recipe %1 macht dasselbe Netz.</translation>
    </message>
    <message>
        <source>Copied the command line that repeats this case: put the volume in place of SCAN and a folder in place of OUT.</source>
        <translation>Die Befehlszeile, die diesen Fall wiederholt, ist kopiert: das Volumen an die Stelle von SCAN setzen und einen Ordner an die von OUT.</translation>
    </message>
    <message>
        <source>Copied a methods paragraph on this mesh.</source>
        <translation>Ein Methodenabsatz (englisch) über dieses Netz ist kopiert.</translation>
    </message>
    <message>
        <source>Copied a methods paragraph on a mesh of earlier parameters: run again for the present ones.</source>
        <translation>Der kopierte Methodenabsatz beschreibt ein Netz früherer Parameter: für die jetzigen neu rechnen.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ResultModel</name>
    <message>
        <source>tick a part on</source>
        <translation>Teil anwählen</translation>
    </message>
    <message>
        <source>tick a part off</source>
        <translation>Teil abwählen</translation>
    </message>
    <message>
        <source>keep only one part</source>
        <translation>Nur einen Teil behalten</translation>
    </message>
    <message>
        <source>Such a surface is not begun: %1.</source>
        <translation>Eine solche Oberfläche wird nicht begonnen: %1.</translation>
    </message>
</context>
<context>
    <name>angiomesh::ReviewPanel</name>
    <message>
        <source>Hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Enge</translation>
    </message>
    <message>
        <source>Missed?</source>
        <translation>Übersehen?</translation>
    </message>
    <message>
        <source>Island</source>
        <translation>Insel</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>Of the whole segmentation, from 1, worst, to 5, best</source>
        <translation>Der ganzen Segmentierung, von 1 (schlechteste) bis 5 (beste)</translation>
    </message>
    <message>
        <source>Given to an earlier result</source>
        <translation>Für ein früheres Ergebnis vergeben</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Looks for small holes, necks, high vesselness outside, and small parts that hang on nothing</source>
        <translation>Sucht kleine Löcher, Engen, hohe Vesselness außerhalb und kleine Teile, die an nichts hängen</translation>
    </message>
    <message>
        <source>Doubt</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>Add at the crosshair</source>
        <translation>Am Fadenkreuz neu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Anmerkung</translation>
    </message>
    <message>
        <source>Doubtful places</source>
        <translation>Fragliche Stellen</translation>
    </message>
    <message>
        <source>Looking for doubtful places…</source>
        <translation>Fragliche Stellen werden gesucht…</translation>
    </message>
    <message>
        <source>%1 of %2 doubtful places seen</source>
        <translation>%1 von %2 fraglichen Stellen gesehen</translation>
    </message>
    <message>
        <source>Of the vessel there, from 1, worst, to 5, best</source>
        <translation>Des Gefäßes dort, von 1 (schlechteste) bis 5 (beste)</translation>
    </message>
</context>
<context>
    <name>angiomesh::RunModel</name>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>zur Ruhe gekommen</translation>
    </message>
    <message>
        <source>not converged at the limit</source>
        <translation>an der Grenze nicht konvergiert</translation>
    </message>
    <message>
        <source>finished by hand (a next run evolves again)</source>
        <translation>von Hand abgeschlossen (der nächste Lauf rechnet neu)</translation>
    </message>
    <message>
        <source>ended as asked</source>
        <translation>wie verlangt beendet</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 fehlgeschlagen: %2</translation>
    </message>
    <message>
        <source>Evolve: label %1, %2 voxels, moved by at most %3 voxel.</source>
        <translation>Evolution: Label %1, %2 Voxel, um höchstens %3 Voxel bewegt.</translation>
    </message>
    <message>
        <source>Evolve: %1 after %2 iterations, threshold b = %3.</source>
        <translation>Evolution: %1 nach %2 Iterationen, Schwelle b = %3.</translation>
    </message>
    <message>
        <source>Evolve: segmented by another method than the level set.</source>
        <translation>Evolution: mit einer anderen Methode als dem Level-Set segmentiert.</translation>
    </message>
    <message>
        <source>Cancelled in step %1.</source>
        <translation>Abgebrochen im Schritt %1.</translation>
    </message>
    <message>
        <source>Done up to %1</source>
        <translation>Fertig bis %1</translation>
    </message>
    <message>
        <source>, %1 triangles, %2 s</source>
        <translation>, %1 Dreiecke, %2 s</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeedList</name>
    <message>
        <source>Remove seed</source>
        <translation>Saatpunkt entfernen</translation>
    </message>
    <message>
        <source>%1 seeds in use</source>
        <translation>%1 Saatpunkte genutzt</translation>
    </message>
    <message>
        <source>No seeds yet</source>
        <translation>Noch keine Saatpunkte</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeedMenu</name>
    <message>
        <source>Seeds</source>
        <translation>Saatpunkte</translation>
    </message>
    <message>
        <source>Put a seed here</source>
        <translation>Saatpunkt hierher setzen</translation>
    </message>
    <message>
        <source>Remove this seed</source>
        <translation>Diesen Saatpunkt entfernen</translation>
    </message>
    <message>
        <source>This vessel only</source>
        <translation>Nur dieses Gefäß</translation>
    </message>
    <message>
        <source>The only seed is here, and parts without a seed are left out</source>
        <translation>Der einzige Saatpunkt liegt hier, und Teile ohne Saatpunkt werden ausgelassen</translation>
    </message>
</context>
<context>
    <name>angiomesh::SensitivityPanel</name>
    <message>
        <source>Try the parameters</source>
        <translation>Parameter ausprobieren</translation>
    </message>
    <message>
        <source>Runs the segmentation in the background with each main parameter a step up and a step down. The case stays as it is.</source>
        <translation>Segmentiert im Hintergrund mit jedem Hauptparameter einen Schritt höher und einen tiefer. Der Fall bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Paint the wall</source>
        <translation>Wand färben</translation>
    </message>
    <message>
        <source>Shows in 3D, in place of the mesh, the wall with its moves in colour</source>
        <translation>Zeigt in 3D anstelle des Netzes die Wand mit ihren Verschiebungen in Farbe</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Mean, mm</source>
        <translation>Mittel, mm</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>The parameter, its value, and the value that was tried</source>
        <translation>Der Parameter, sein Wert und der ausprobierte Wert</translation>
    </message>
    <message>
        <source>Mean move of the wall, outwards positive, without what is lost</source>
        <translation>Mittlere Verschiebung der Wand, nach außen positiv, ohne Verlorenes</translation>
    </message>
    <message>
        <source>95 % of the wall move less than this either way, mm</source>
        <translation>95 % der Wand verschieben sich weniger, nach außen oder innen, mm</translation>
    </message>
    <message>
        <source>Part of the wall whose vessel is gone</source>
        <translation>Teil der Wand, dessen Gefäß verschwunden ist</translation>
    </message>
    <message>
        <source>By how much the vessels have more volume</source>
        <translation>Um wie viel die Gefäße mehr Volumen haben</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Länge, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Radius, mm</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>The longest first; a click takes the panes there</source>
        <translation>Der längste zuerst; ein Klick führt die Ansichten dorthin</translation>
    </message>
    <message>
        <source>Of its centre line</source>
        <translation>Seiner Mittellinie</translation>
    </message>
    <message>
        <source>Mean radius</source>
        <translation>Mittlerer Radius</translation>
    </message>
    <message>
        <source>By how much the mean radius is larger after the step, mm; with all steps the largest change</source>
        <translation>Um wie viel der mittlere Radius nach dem Schritt größer ist, mm; bei allen Schritten die größte Änderung</translation>
    </message>
    <message>
        <source>Part of its wall that is lost; with all steps the largest part</source>
        <translation>Verlorener Teil seiner Wand; bei allen Schritten der größte</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Wird ausprobiert…</translation>
    </message>
    <message>
        <source>By how much does the wall move when a parameter does?</source>
        <translation>Um wie viel verschiebt sich die Wand, wenn ein Parameter sich ändert?</translation>
    </message>
    <message>
        <source>Of earlier parameters: try again for the present ones.</source>
        <translation>Von früheren Parametern: Probieren Sie die jetzigen noch einmal aus.</translation>
    </message>
    <message>
        <source>%1 steps in %2</source>
        <translation>%1 Schritte in %2</translation>
    </message>
    <message>
        <source>All: largest move</source>
        <translation>Alle: größte Verschiebung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>angiomesh::SeriesDialog</name>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>uneven slices</source>
        <translation>ungleiche Schichten</translation>
    </message>
    <message>
        <source>no volume</source>
        <translation>kein Volumen</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>%1 volumes were found.</source>
        <translation>%1 Volumen gefunden.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Spacing, mm</source>
        <translation>Abstand, mm</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>angiomesh::SliceView</name>
    <message>
        <source>%1, voxel %2,%3,%4</source>
        <translation>%1, Voxel %2,%3,%4</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
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
        <translation>Mittel</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>um %1° gedreht</translation>
    </message>
    <message>
        <source>Patient axes</source>
        <translation>Patientenachsen</translation>
    </message>
</context>
<context>
    <name>angiomesh::StepPanel</name>
    <message>
        <source>Run to here</source>
        <translation>Bis hier rechnen</translation>
    </message>
    <message>
        <source>Runs the pipeline up to this step</source>
        <translation>Rechnet die Pipeline bis zu diesem Schritt</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>fresh</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>fresh, %1 s</source>
        <translation>aktuell, %1 s</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>More (changed: %1)</source>
        <translation>Mehr (geändert: %1)</translation>
    </message>
</context>
<context>
    <name>angiomesh::SurfaceNote</name>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>%1 expected</source>
        <translation>%1 erwartet</translation>
    </message>
    <message>
        <source>about %1 triangles</source>
        <translation>etwa %1 Dreiecke</translation>
    </message>
    <message>
        <source>%1 % from the front</source>
        <translation>%1 % aus der Front</translation>
    </message>
    <message>
        <source>%1 components verified</source>
        <translation>%1 Komponenten geprüft</translation>
    </message>
    <message>
        <source>Not fit for a solver: %1</source>
        <translation>Nicht tauglich für einen Löser: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>angiomesh::SurfacePane</name>
    <message>
        <source>Moves of the wall, out of date</source>
        <translation>Verschiebungen der Wand, veraltet</translation>
    </message>
    <message>
        <source>Moves of the wall</source>
        <translation>Verschiebungen der Wand</translation>
    </message>
</context>
<context>
    <name>angiomesh::ViewButtons</name>
    <message>
        <source>From the front (A)</source>
        <translation>Von vorn (A)</translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation>Von hinten (P)</translation>
    </message>
    <message>
        <source>From the patient&apos;s left (L)</source>
        <translation>Von der linken Patientenseite (L)</translation>
    </message>
    <message>
        <source>From the patient&apos;s right (Shift+R)</source>
        <translation>Von der rechten Patientenseite (Shift+R)</translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation>Vom Kopf (S)</translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation>Von den Füßen (I)</translation>
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
        <translation>axial</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>koronar</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>sagittal</translation>
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
        <translation>Schichten: %1</translation>
    </message>
    <message>
        <source>Some parts hidden</source>
        <translation>Einige Teile verborgen</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <translation>Volumen: %1</translation>
    </message>
    <message>
        <source>3D, result</source>
        <translation>3D, Ergebnis</translation>
    </message>
    <message>
        <source>MIP: result</source>
        <translation>MIP: Ergebnis</translation>
    </message>
    <message>
        <source>3D, beside</source>
        <translation>3D, daneben</translation>
    </message>
    <message>
        <source>Preview in the box</source>
        <translation>Vorschau im Kasten</translation>
    </message>
</context>
<context>
    <name>angiomesh::ViewTools</name>
    <message>
        <source>Two by two</source>
        <translation>Zwei mal zwei</translation>
    </message>
    <message>
        <source>One large, three small</source>
        <translation>Eine groß, drei klein</translation>
    </message>
    <message>
        <source>One alone</source>
        <translation>Eine allein</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Navigate</source>
        <translation>Navigieren</translation>
    </message>
    <message>
        <source>Pick seed</source>
        <translation>Saatpunkt</translation>
    </message>
    <message>
        <source>Draw ROI</source>
        <translation>ROI ziehen</translation>
    </message>
    <message>
        <source>Cut vessel</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Left button moves the crosshair (Engineering)</source>
        <translation>Linke Taste bewegt das Fadenkreuz (Engineering)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Ctrl+U</source>
        <translation>Ctrl+U</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Interpolate slices</source>
        <translation>Schichten interpolieren</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Reset all panes</source>
        <translation>Alle Ansichten zurücksetzen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Show the log</source>
        <translation>Protokoll zeigen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Only axial</source>
        <translation>Nur axial</translation>
    </message>
    <message>
        <source>Only sagittal</source>
        <translation>Nur sagittal</translation>
    </message>
    <message>
        <source>Only coronal</source>
        <translation>Nur koronar</translation>
    </message>
    <message>
        <source>Only 3D</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Language, from the next start</source>
        <translation>Sprache, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source> Layer </source>
        <translation> Bild </translation>
    </message>
    <message>
        <source>  Slab </source>
        <translation>  Slab </translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
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
        <translation>Mittel</translation>
    </message>
    <message>
        <source>by pane</source>
        <translation>je Ansicht</translation>
    </message>
    <message>
        <source>Of all slice panes. The right-click menu of a pane, M and Alt with the wheel change one of them.</source>
        <translation>Für alle Schichtansichten. Das Rechtsklick-Menü einer Ansicht, M sowie Alt mit dem Mausrad ändern nur eine.</translation>
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
        <translation>Volumen in 3D</translation>
    </message>
    <message>
        <source>Result beside the image</source>
        <translation>Ergebnis neben dem Bild</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>3D MIP</source>
        <translation>3D-MIP</translation>
    </message>
    <message>
        <source>Shaded, MR angiography</source>
        <translation>Schattiert, MR-Angiographie</translation>
    </message>
    <message>
        <source>Shaded, CT angiography</source>
        <translation>Schattiert, CT-Angiographie</translation>
    </message>
</context>
<context>
    <name>angiomesh::WelcomePage</name>
    <message>
        <source>Open again</source>
        <translation>Erneut öffnen</translation>
    </message>
    <message>
        <source>From an angiogram (MRA or CTA) to a vessel surface that a flow solver accepts.</source>
        <translation>Von der Angiographie (MRA oder CTA) zur Gefäßoberfläche, die ein Strömungslöser annimmt.</translation>
    </message>
    <message>
        <source>Or drop a file, a folder or a case anywhere on this window.</source>
        <translation>Oder eine Datei, einen Ordner oder einen Fall irgendwo auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Not a medical device: research use only.</source>
        <translation>Kein Medizinprodukt: nur für die Forschung.</translation>
    </message>
</context>
<context>
    <name>angiomesh::WhyPanel</name>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>The voxel of the grid that the method works on, and where it lies</source>
        <translation>Das Voxel des Gitters, auf dem die Methode rechnet, und wo es liegt</translation>
    </message>
    <message>
        <source>Distance to the wall</source>
        <translation>Abstand zur Wand</translation>
    </message>
    <message>
        <source>Negative inside</source>
        <translation>Innen negativ</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Of the preprocessed image, and how far that is on the way from the surroundings to the lumen nearby</source>
        <translation>Des vorverarbeiteten Bildes, und wie weit das auf dem Weg von der Umgebung zum nahen Lumen ist</translation>
    </message>
    <message>
        <source>Vesselness v</source>
        <translation>Vesselness v</translation>
    </message>
    <message>
        <source>The value of largest magnitude over all scales, and the thresholds that it is compared with</source>
        <translation>Der dem Betrag nach größte Wert über alle Skalen, und die Schwellen, mit denen er verglichen wird</translation>
    </message>
    <message>
        <source>Best scale</source>
        <translation>Beste Skala</translation>
    </message>
    <message>
        <source>The scale at which that value was found, of those searched</source>
        <translation>Die Skala, bei der dieser Wert gefunden wurde, aus den durchsuchten</translation>
    </message>
    <message>
        <source>Eigenvalues</source>
        <translation>Eigenwerte</translation>
    </message>
    <message>
        <source>Of the Hessian times σ² at that scale: in a bright vessel the first is near 0, and both others are negative and alike</source>
        <translation>Der Hesse-Matrix mal σ² bei dieser Skala: In einem hellen Gefäß ist der erste nahe 0, und die beiden anderen sind negativ und ähnlich</translation>
    </message>
    <message>
        <source>Speed p</source>
        <translation>Geschwind. p</translation>
    </message>
    <message>
        <source>1 pulls the front outwards, −1 inwards</source>
        <translation>1 zieht die Front nach außen, −1 nach innen</translation>
    </message>
    <message>
        <source>Curvature term</source>
        <translation>Krümmungsterm</translation>
    </message>
    <message>
        <source>(1 − γ) |d κ|: pushes the front on at thin vessels</source>
        <translation>(1 − γ) |d κ|: treibt die Front an dünnen Gefäßen weiter</translation>
    </message>
    <message>
        <source>Speed F</source>
        <translation>Geschwind. F</translation>
    </message>
    <message>
        <source>γ p + (1 − γ) |d κ|: the front moves outwards where it is positive</source>
        <translation>γ p + (1 − γ) |d κ|: Wo es positiv ist, läuft die Front nach außen</translation>
    </message>
    <message>
        <source>Run to Evolve, by the level set, to see why the voxel under the crosshair is vessel or not.</source>
        <translation>Bis Evolution rechnen, mit dem Level-Set, um zu sehen, warum das Voxel unter dem Fadenkreuz Gefäß ist oder nicht.</translation>
    </message>
    <message>
        <source>Open a volume first.</source>
        <translation>Zuerst ein Volumen öffnen.</translation>
    </message>
    <message>
        <source>voxel %1,%2,%3, %4</source>
        <translation>Voxel %1,%2,%3, %4</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>, %1 of the way from %2 to %3</source>
        <translation>, %1 des Weges von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 (b = %2, a = %3)</source>
        <translation>%1 (b = %2, a = %3)</translation>
    </message>
    <message>
        <source>σ = %1 mm of %2 to %3 mm</source>
        <translation>σ = %1 mm aus %2 bis %3 mm</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 (κ = %2 per voxel)</source>
        <translation>%1 (κ = %2 je Voxel)</translation>
    </message>
</context>
<context>
    <name>angiomesh::WindowMenu</name>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window: %1</source>
        <translation>Fenster: %1</translation>
    </message>
    <message>
        <source>Other windows of the file</source>
        <translation>Weitere Fenster der Datei</translation>
    </message>
    <message>
        <source>Set window and level…</source>
        <translation>Fenster und Mitte setzen…</translation>
    </message>
    <message>
        <source>Reset window and level</source>
        <translation>Fenster und Mitte zurücksetzen</translation>
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
        <translation>Fenster und Mitte</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Mitte</translation>
    </message>
</context>
<context>
    <name>angiomesh::Workspaces</name>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>The images, with nothing beside them</source>
        <translation>Nur die Bilder, nichts daneben</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Einstellen</translation>
    </message>
    <message>
        <source>The steps of the pipeline and the convergence</source>
        <translation>Die Schritte der Pipeline und die Konvergenz</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>The mesh inspector, the ports and the log</source>
        <translation>Netzinspektor, Öffnungen und Protokoll</translation>
    </message>
    <message>
        <source>Reset this workspace</source>
        <translation>Diesen Arbeitsbereich zurücksetzen</translation>
    </message>
</context>
<context>
    <name>angiomesh::WorstList</name>
    <message>
        <source>Choose a row to go there in 3D and in the slices; the arrow keys go on.</source>
        <translation>Eine Zeile wählen, um in 3D und in den Schichten dorthin zu gehen; die Pfeiltasten führen weiter.</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
</context>
</TS>
