HSPD=20000      ;* Set the high speed to 20000 pulses/sec
LSPD=1000       ;* Set the low speed to 1000 pulses/sec
ACC=300         ;* Set the acceleration to 300 msec
EO=1            ;* Enable the motor power
WHILE 1=1       ;* Forever loop
  IF DI1=1      ;* If digital input 1 is on
    X1000       ;* Move to 1000
    WAITX      ;* Wait for X-axis move to complete
  ELSEIF DI2=1 ;* If digital input 2 is on
    X2000       ;* Move to 2000
    WAITX      ;* Wait for X-axis move to complete
  ELSEIF DI3=1 ;* If digital input 3 is on
    X3000       ;* Move to 3000
    WAITX      ;* Wait for X-axis move to complete
  ELSEIF DI5=1 ;* If digital input 5 is on
    HOMEX-     ;* Home the motor in negative direction
    WAITX      ;* Wait for X-axis move to complete
  ENDIF
  V1=MSTX      ;* Store the motor status to variable 1
  V2=V1&7      ;* Get first 3 bits
  IF V2!=0
    DO1=1
  ELSE
    DO1=0
  ENDIF
ENDWHILE       ;* Go back to WHILE statement
END

; PMX manual, ch. 11, example 6, as printed.
;# for pmx-4ex-sa
;# after 50 count:move_X1000=0
;# at 50 DI1=1
;# at 75 DI1=0
;# after 200 PX=1000 DO1=0 count:move_X1000=1
;# at 200 DI2=1
;# at 225 DI2=0
;# after 400 PX=2000
;# at 400 DI3=1
;# at 425 DI3=0
;# after 600 PX=3000
;# at 600 DI5=1
;# at 625 DI5=0
;# after 700 PX=0 did:home_X-_switch DO1=0
