; For a PMX-4EX-SA: the outline of a plate with X and Y, 4000 by 2000 pulses and round at its right end, while output 1
; is on (a laser, say). It ends where it began.
HSPD=4000
LSPD=200
ACC=100
EO=3                       ; the motors of X and Y
PX=0
PY=0
ABS
DO1=1
X4000Y0
WAITX
ARCN4000:1000:90000:180000 ; half a circle to the left, about 4000, 1000
WAITX
X0Y2000
WAITX
X0Y0
WAITY
DO1=0
END
