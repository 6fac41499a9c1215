/** Time for which values published by hand stay after this tab was closed, minutes: longer than a reload or a break. */
export const KEPT_MINUTES = 60;
