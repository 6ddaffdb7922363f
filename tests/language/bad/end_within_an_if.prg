IF V1=1
END
ENDIF
END
;# for pmx-4ex-sa dmx-k-sa
;# error 1:1 This IF has no ENDIF
;# error 3:1 outside any program
;# error 4:1 no program above this END
