HSPD=20000      ;* Set the high speed to 20000 pulses/sec
LSPD=1000       ;* Set the low speed to 1000 pulses/sec
ACC=300         ;* Set the acceleration to 300 msec
EO=1            ;* Enable the motor power
V1=0            ;* Set variable 1 to zero
WHILE 1=1       ;* Forever loop
    IF DI1=1     ;* If digital input 1 is on, execute the statements
        GOSUB 1  ;* Move to zero
    ENDIF
ENDWHILE        ;* Go back to WHILE statement
END

SUB 1
    XV1         ;* Move to V1 target position
    V1=V1+1000  ;* Increment V1 by 1000
    WHILE DI1=1 ;* Wait until the DI1 is turned off so that
    ENDWHILE    ;* 1000 increment is not continuously done
ENDSUB

; DMX manual, ch. 11, example 5, as printed.
;# for dmx-k-sa
;# at 100 DI1=1
;# after 300 V1=1000 PX=0
;# at 300 DI1=0
;# at 400 DI1=1
;# after 700 V1=2000 PX=1000
;# at 700 DI1=0
;# at 750 DI1=1
;# after 1000 V1=3000 PX=2000
