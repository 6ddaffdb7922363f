; A program of a PMX on a DMX.
X1000Y1000
HOMEY+
ARCP1000:0:90000:90000
V1=AI1
TR=1000
ACCX=300
DO8=1
PRG 2
END
;# for dmx-k-sa
;# error 2:6 one axis, X
;# error 3:1 one axis, X
;# error 4:1 belongs to the PMX-4EX-SA
;# error 5:4 belongs to the PMX-4EX-SA
;# error 6:1 belongs to the PMX-4EX-SA
;# error 7:1 belongs to the PMX-4EX-SA
;# error 8:1 DO1 to DO3
;# error 9:1 END is missing above
;# error 9:5 PRG 0 to PRG 1
