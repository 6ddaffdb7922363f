; For a DMX-K-SA: to and fro ten times, 5000 pulses each way, with a rest of half a second. V1 counts the strokes.
HSPD=20000
LSPD=500
ACC=200
EO=1
SL=0                       ; in pulses
PX=0
ABS
V1=0
WHILE V1<10
  X5000
  WAITX
  DELAY=500
  X0
  WAITX
  DELAY=500
  V1=V1+1
ENDWHILE
END
