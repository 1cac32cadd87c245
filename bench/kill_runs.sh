#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Kills `run`, `run --force`, `convert --openfoam --force`, the export of a mesh and that of its patches at random moments by
# INT, TERM, HUP, PIPE and KILL, and looks at what is left: a whole result or none, the one before or the new one, and after
# the next start nothing hidden.
#   bench/kill_runs.sh PATH/TO/angiomesh-cli [KILLS [RANDOM_SEED [WHAT...]]]
# WHAT: any of run force foam mesh patches volume; all where none is named. One line for each fault, then how many kills left
# none. Some 2 kills a second.
set -u
[ $# -ge 1 ] && [ -x "$1" ] ||
  { echo "usage: bench/kill_runs.sh PATH/TO/angiomesh-cli [KILLS [RANDOM_SEED [WHAT...]]]" >&2; exit 2; }
program=$(realpath "$1")
kills=${2:-2000}
RANDOM=${3:-1}
kinds=("${@:4}")
[ ${#kinds[@]} -gt 0 ] || kinds=(run force foam mesh patches volume)
scratch=$(mktemp -d)
n=0
trap 'rm -rf "$scratch"; [ $n -gt $kills ] || echo "ended at kill $n"' EXIT
cd "$scratch" || exit 2
"$program" phantom bifurcation --size 40 --radius 3 --noise 20 -o case >/dev/null || exit 2
run=(run case/image.mha --set segmentation.keep=largest)
one=(--set smooth.method=none) two=(--set smooth.method=taubin)
# Without what tells the time.
sums() { (cd "$1" && find . -type f ! -name report.json ! -name '*.png' -exec md5sum {} + | sort); }
"$program" "${run[@]}" "${one[@]}" -o one >/dev/null || exit 2
"$program" "${run[@]}" "${two[@]}" -o two >/dev/null || exit 2
"$program" mesh case/truth.mha --cut-ends 3 -o cut.ply >/dev/null 2>&1 || exit 2
"$program" convert cut.ply --openfoam -o foam-one >/dev/null 2>&1 || exit 2
"$program" convert cut.ply --frame ras -o turned.ply >/dev/null 2>&1 || exit 2
# The export of two meshes, or volumes, into folders of their own, by a name: what, file, options.
export_two() {
  for which in one two; do
    mkdir "$1-$which"
    "$program" convert "$4-$which$5" -o "$1-$which/$2" $3 >/dev/null 2>&1 || exit 2
    sums "$1-$which" >"$1-$which.sums"
  done
}
ln -s cut.ply m-one.ply; ln -s turned.ply m-two.ply; ln -s case/truth.mha v-one.mha; ln -s case/image.mha v-two.mha
export_two mesh vessel.ply "" m .ply
export_two patches vessel.stl --patch-files m .ply
export_two volume v.nhdr "" v .mha
for which in one two; do "$program" convert v-$which.mha -o v-$which.nrrd >/dev/null || exit 2; done
sums one >one.sums; sums two >two.sums; sums foam-one >foam.sums
milliseconds() { local start=$(date +%s%N); "$@" >/dev/null 2>&1; echo $((($(date +%s%N) - start) / 1000000)); }
mkdir -p time
whole=$(milliseconds "$program" "${run[@]}" "${one[@]}" -o time/run)
short=$(milliseconds "$program" convert cut.ply -o time/vessel.stl --patch-files)
signals=(INT TERM HUP PIPE KILL)
# A script's processes in the background are deaf to INT, and under nohup to HUP.
heard=(env --default-signal=INT,TERM,HUP,PIPE)
faults=0
fault() { faults=$((faults + 1)); echo "kill $n, $signal, $what: $1"; }
hidden() { find . -mindepth 1 -maxdepth 2 -name '.angiomesh*' | head -1; }
# A header and the voxels that it names, whatever their file is called.
is_volume() {
  [ "$(ls volume | wc -l)" -eq 2 ] && "$program" convert volume/v.nhdr -o now.nrrd >/dev/null 2>&1 || return 1
  cmp -s now.nrrd v-one.nrrd || cmp -s now.nrrd v-two.nrrd
}
# Whether a folder of an export holds what one of the two wrote, and nothing else.
is_one_of_two() {
  [ "$1" = volume ] && { is_volume; return; }
  sums "$1" >now.sums
  cmp -s now.sums "$1-one.sums" || cmp -s now.sums "$1-two.sums"
}
for ((n = 1; n <= kills; n++)); do
  signal=${signals[RANDOM % 5]}
  which=$((RANDOM % 2)); which=${which/0/one}; which=${which/1/two}
  what=${kinds[RANDOM % ${#kinds[@]}]}
  most=$short
  case $what in
    run) place=new; most=$whole; call=("${run[@]}" "${one[@]}" -o new) ;;
    force) place=forced; most=$whole; call=("${run[@]}" "${two[@]}" -o forced --force)
       [ -d forced ] || cp -r one forced ;;
    foam) place=foam; most=$((whole / 4 + 50)); call=(convert cut.ply --openfoam -o foam --force)
       [ -d foam ] || cp -r foam-one foam ;;
    mesh) place=mesh; call=(convert m-$which.ply -o mesh/vessel.ply) ;;
    patches) place=patches; call=(convert m-$which.ply -o patches/vessel.stl --patch-files) ;;
    volume) place=volume; call=(convert v-$which.mha -o volume/v.nhdr) ;;
    *) echo "no such thing to kill: $what" >&2; exit 2 ;;
  esac
  [ -d $place ] || [ $place = new ] || cp -r $place-one $place
  "${heard[@]}" "$program" "${call[@]}" >/dev/null 2>stderr &
  process=$!
  # As often near the end, where files move into place, as before.
  time=$((RANDOM % (most * 11 / 10)))
  [ $((RANDOM % 2)) -eq 0 ] && time=$((most * 7 / 10 + RANDOM % (most * 4 / 10 + 1)))
  sleep "$(printf '%d.%03d' $((time / 1000)) $((time % 1000)))"
  kill -$signal $process 2>/dev/null
  wait $process 2>/dev/null
  code=$?
  # 128 and the signal: it came before the program had begun.
  case $code in 0 | 4 | 129 | 130 | 137 | 141 | 143) ;; *) fault "exit code $code, $(tail -1 stderr)" ;; esac
  # The next start finishes or clears; it replaces nothing of what was killed, but for the case.
  case $place in
    foam) timeout 60 "$program" convert cut.ply --openfoam -o foam --force >/dev/null 2>&1 ;;
    mesh | patches | volume)
      next=(); [ $((RANDOM % 2)) -eq 0 ] && next=(--patch-files)
      timeout 60 "$program" convert cut.ply -o $place/next.stl "${next[@]}" >/dev/null 2>&1
      rm -f $place/next* ;;
    *) timeout -s INT 60 "$program" "${run[@]}" --until preprocess -o $place >/dev/null 2>&1 ;;
  esac
  left=$(hidden)
  [ -z "$left" ] || fault "$left is left"
  case $place in
    new) [ -f new/vessels.ply ] && { sums new >now.sums; cmp -s now.sums one.sums || fault "a part of a result"; }
         rm -rf new ;;
    forced) sums forced >now.sums
         cmp -s now.sums one.sums || cmp -s now.sums two.sums || fault "two results mixed"
         [ $((RANDOM % 2)) -eq 0 ] && rm -rf forced ;;
    foam) sums foam >now.sums; cmp -s now.sums foam.sums || fault "the case is not whole" ;;
    *) is_one_of_two $place || { fault "neither what was there nor what was written"; rm -rf $place; } ;;
  esac
  rm -rf .angiomesh-* $place/.angiomesh-*
done
echo "$((kills - faults)) of $kills kills left nothing behind"
[ $faults -eq 0 ]
