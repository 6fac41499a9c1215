import type { CameraCalibration } from '@ubii/vision/markers';

/** Largest errors of a good and a fair calibration, pixels. */
const GOOD_PX = 0.5;
const FAIR_PX = 1;

/** Describes a calibration: quality, advice and figures. */
export function calibrationWords(calibration: CameraCalibration) {
  const { width, height, fx, fy, reprojectionErrorPx: errorPx = NaN } = calibration;
  const angle = (side: number, focal: number): string =>
    `${((Math.atan(side / 2 / focal) * 360) / Math.PI).toFixed(1)}°`;
  const [quality, advice] =
    errorPx <= GOOD_PX
      ? (['Good', 'The views are consistent.'] as const)
      : errorPx <= FAIR_PX
        ? ([
            'Fair',
            'Usable. For a better result, use more light and hold the board still.',
          ] as const)
        : ([
            'Poor',
            'Not usable. Check the size of the squares and start over with a flat board in bright light.',
          ] as const);
  return {
    quality,
    advice,
    facts: [
      { name: 'Reprojection error', value: `${errorPx.toFixed(2)} px` },
      { name: 'Field of view', value: `${angle(width, fx)} × ${angle(height, fy)}` },
      { name: 'Focal lengths', value: `${fx.toFixed(0)} × ${fy.toFixed(0)} px` },
      { name: 'Picture', value: `${width} × ${height}` },
    ],
  };
}
