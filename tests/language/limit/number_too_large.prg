V1=2147483648
V2=-2147483649
X134217728
X-134217728
X134217727
END
;# for pmx-4ex-sa dmx-k-sa
;# error 1:4 too large
;# error 2:4 too large
;# error 3:2 28 bits
