# How far is a picture from the right one, in units of noise? Prints "EVERYWHERE SOMEWHERE LEVEL".
#
# Input: one picture per line, its linear values. -v rights=N: the first N lines are the right picture with N seeds; the last
# line is judged; -v other=1: against the picture on the line before, in place of the right one. Values are compared as a screen shows them (clipped at 1, gamma 2.2). Each is divided by its noise: the
# spread over seeds, averaged over neighbours, and never below FLOOR, which no eye tells apart.
#   EVERYWHERE  root mean square over the picture, over the largest that a right picture has against the others
#   SOMEWHERE   the same for the worst place
#   LEVEL       mean of the picture over the mean of the right one
BEGIN { FLOOR = 0.008 }
function eye(x) { return x <= 0 ? 0 : x >= 1 ? 1 : x ^ (1 / 2.2) }
{
    for (i = 1; i <= NF; i++) {
        value[NR, i] = $i + 0 == $i + 0 ? eye($i + 0) : 0
        total[NR] += $i
    }
    if (NF > width) width = NF
}
# Mean and largest noise-free distance of picture p from the right ones, p left out: `rms` and `worst`.
function measure(p,    i, r, n, mean, d, sum) {
    worst = 0
    for (i = 1; i <= width; i++) {
        mean = n = 0
        for (r = 1; r <= rights; r++)
            if (r != p) {
                mean += value[r, i]
                n++
            }
        d = (value[p, i] - (other && p == NR ? value[NR - 1, i] : mean / n)) / noise[i]
        sum += d * d
        if (d * d > worst * worst) worst = d < 0 ? -d : d
    }
    rms = sqrt(sum / width)
}
END {
    for (i = 1; i <= width; i++) {
        mean = square = 0
        for (r = 1; r <= rights; r++) {
            mean += value[r, i] / rights
            square += value[r, i] ^ 2 / rights
        }
        variance[i] = (square - mean ^ 2) * rights / (rights - 1)
    }
    reach = 6 # two pixels to each side; three channels each
    for (i = 1; i <= width; i++) {
        sum = n = 0
        for (j = i - reach; j <= i + reach; j++)
            if (j >= 1 && j <= width) {
                sum += variance[j]
                n++
            }
        noise[i] = sqrt(sum / n + FLOOR ^ 2)
    }
    for (r = 1; r <= rights; r++) {
        measure(r)
        if (rms > most_rms) most_rms = rms
        if (worst > most_worst) most_worst = worst
        right_total += total[r] / rights
    }
    measure(NR)
    printf "%.3g %.3g %.3g\n", rms / most_rms, worst / most_worst, total[NR] / right_total
}
