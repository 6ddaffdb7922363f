V1=2147483648
V2=-2147483649
X134217728
X-134217728
X134217727
END
;# for pmx-4ex-sa dmx-k-sa
;# error 1:4 out of range
;# error 2:4 out of range
;# error 3:2 28 bits
