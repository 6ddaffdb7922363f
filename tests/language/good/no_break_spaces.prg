V1 = 7
IF V1=7 
  V2=1
ENDIF
END
;# for pmx-4ex-sa dmx-k-sa
;# after 20 V2=1
