import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { fitCamera, type FrameRect, type Lens, type Point3 } from './fit-camera.ts';

const LENS: Lens = { fovDeg: 22, pitchDeg: 28, yawDeg: 9, aspect: 16 / 9 };
const RECT: FrameRect = { left: 0.3, right: 0.95, top: 0.1, bottom: 0.8 };
const POINTS: readonly Point3[] = [
  { x: -12, y: 0, z: -5 },
  { x: 10, y: 0, z: 4 },
  { x: 3, y: 6, z: -9 },
];

/** Projection of a point by three.js itself, shares of the picture from the top left. */
function drawn(point: Point3, lens: Lens): { x: number; y: number } {
  const { target, distance, shiftX, shiftY } = fitCamera(POINTS, lens, RECT);
  const camera = new PerspectiveCamera(lens.fovDeg, lens.aspect, 1, 500);
  const [pitch, yaw] = [(lens.pitchDeg * Math.PI) / 180, (lens.yawDeg * Math.PI) / 180];
  camera.position
    .set(Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch))
    .multiplyScalar(distance)
    .add(new Vector3(target.x, target.y, target.z));
  camera.lookAt(target.x, target.y, target.z);
  camera.updateMatrixWorld();
  const { x, y } = new Vector3(point.x, point.y, point.z).project(camera);
  return { x: (x + shiftX + 1) / 2, y: (1 - y - shiftY) / 2 };
}

describe('fit camera', () => {
  it.each([16 / 9, 4 / 3, 21 / 9])(
    'draws all points in their part of the picture (%f)',
    (aspect) => {
      const places = POINTS.map((point) => drawn(point, { ...LENS, aspect }));
      for (const { x, y } of places) {
        expect(x).toBeGreaterThan(RECT.left - 1e-6);
        expect(x).toBeLessThan(RECT.right + 1e-6);
        expect(y).toBeGreaterThan(RECT.top - 1e-6);
        expect(y).toBeLessThan(RECT.bottom + 1e-6);
      }
    },
  );

  it('is as near as it can be', () => {
    const places = POINTS.map((point) => drawn(point, LENS));
    const size = (axis: 'x' | 'y'): number =>
      Math.max(...places.map((place) => place[axis])) -
      Math.min(...places.map((place) => place[axis]));
    const used = Math.max(size('x') / 0.65, size('y') / 0.7);
    expect(used).toBeGreaterThan(0.999);
    expect(used).toBeLessThan(1.0001);
  });
});
