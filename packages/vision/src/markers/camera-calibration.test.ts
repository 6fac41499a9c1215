import { describe, expect, it } from 'vitest';
import { assumedCalibration, calibrationFor, parseCalibration } from './camera-calibration.ts';

const CALIBRATION = {
  width: 1280,
  height: 720,
  fx: 900,
  fy: 905,
  cx: 650,
  cy: 350,
  distortion: [0.1, -0.2, 0, 0, 0],
  reprojectionErrorPx: 0.3,
  views: 12,
};

describe('calibrations', () => {
  it('are the same after JSON', () => {
    expect(parseCalibration(JSON.stringify(CALIBRATION))).toEqual(CALIBRATION);
  });

  it.each([
    ['no JSON', '{', 'not JSON'],
    ['null', 'null', '"width"'],
    ['a missing number', JSON.stringify({ ...CALIBRATION, fy: null }), '"fy"'],
    ['a negative focal length', JSON.stringify({ ...CALIBRATION, fx: -1 }), 'above 0'],
    ['too few coefficients', JSON.stringify({ ...CALIBRATION, distortion: [1] }), '5 numbers'],
  ])('with %s are refused', (_what, json, message) => {
    expect(() => parseCalibration(json)).toThrow(message);
  });

  it('scale about the edge of the picture, not the centre of the first pixel', () => {
    const half = calibrationFor(CALIBRATION, 640, 360);
    expect(half).toMatchObject({ fx: 450, fy: 452.5, cx: 324.75, cy: 174.75 });
  });

  it('do not fit pictures of another shape', () => {
    expect(() => calibrationFor(CALIBRATION, 640, 480)).toThrow('640 × 480');
    expect(() => calibrationFor(CALIBRATION, 720, 1280)).toThrow(RangeError);
  });

  it('assumed, show 60 degrees on the longer side', () => {
    const { fx, cx, cy } = assumedCalibration(1280, 720);
    expect((2 * Math.atan(640 / fx) * 180) / Math.PI).toBeCloseTo(60);
    expect([cx, cy]).toEqual([639.5, 359.5]);
    expect(assumedCalibration(720, 1280).fx).toBe(fx);
  });
});
