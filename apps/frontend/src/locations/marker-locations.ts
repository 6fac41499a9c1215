export const PRINT_MARKERS_PATH = '/devices/camera/print-markers';
export const PRINT_BOARD = `${PRINT_MARKERS_PATH}?what=board`;
export const CALIBRATE_PATH = '/devices/camera/calibrate';
