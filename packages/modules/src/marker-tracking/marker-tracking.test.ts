import type { Object2DList, Object3DList } from '@ubii/proto';
import { MARKER_IMAGE_SIZE, markerImage, markerImageFile } from '@ubii/vision/testing/markers';
import { beforeAll, describe, expect, it } from 'vitest';
import { Sample, type DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision } from '../../test/vision-assets.ts';
import { markerTracking } from './marker-tracking.ts';

let module: DrivenModule;
beforeAll(async () => {
  module = await driveWithVision(markerTracking);
}, 60_000);

const grey = () => ({ width: 640, height: 480, dataFormat: 0, data: markerImage().data });
const jpeg = () => ({ width: 0, height: 0, dataFormat: 0, data: markerImageFile() });

/** One image, later than the rate asks for. */
const track = async (image: unknown, parameters: object = {}) =>
  (await module.run(1000, { image, markerSize: MARKER_IMAGE_SIZE, ...parameters }, ['image'])) as {
    markers?: Object3DList;
    outlines?: Object2DList;
    error?: string;
    decodeMs?: number;
    durationMs?: number;
  };

describe('marker-tracking', () => {
  it.each([
    ['raw pixels', grey],
    ['a JPEG file', jpeg],
  ])('puts out names, poses and outlines, from %s', async (_what, image) => {
    const { markers, outlines, decodeMs, durationMs } = await track(image());
    expect(markers?.elements.map(({ id }) => id)).toEqual(['aruco_4x4_50:7', 'aruco_4x4_50:23']);
    const [first, second] = markers!.elements;
    const { position, quaternion } = first!.pose!;
    expect(position!.x).toBeCloseTo(-0.08, 2);
    expect(position!.y).toBeCloseTo(0.02, 2);
    expect(position!.z).toBeCloseTo(-0.5, 2);
    expect(quaternion!.w).toBeGreaterThan(0.995);
    expect(first!.size).toEqual({ x: MARKER_IMAGE_SIZE, y: MARKER_IMAGE_SIZE, z: 0 });
    const turn = second!.pose!.quaternion!;
    expect((2 * Math.atan2(turn.y, turn.w) * 180) / Math.PI).toBeCloseTo(30, -0.5);

    const outline = outlines!.elements[0]!;
    const { corners, axes } = JSON.parse(outline.userDataJson) as Record<string, number[][]>;
    expect(corners![0]![0]).toBeCloseTo(outline.pose!.position!.x, 2);
    expect(corners![2]![1]).toBeCloseTo(outline.pose!.position!.y + outline.size!.y, 2);
    expect(axes).toHaveLength(4);
    expect(decodeMs).toBeGreaterThanOrEqual(0);
    expect(durationMs).toBeGreaterThan(decodeMs!);
  });

  it('looks only for the ids and the dictionary asked for', async () => {
    const asked = await track(grey(), { ids: { elements: [23] } });
    expect(asked.markers?.elements.map(({ id }) => id)).toEqual(['aruco_4x4_50:23']);
    const other = await track(grey(), { ids: undefined, dictionary: 'apriltag_36h11' });
    expect(other.markers?.elements).toEqual([]);
    await track(grey(), { dictionary: undefined });
  });

  it('uses a calibration, and says what is wrong with one', async () => {
    const focal = 2 * (320 / Math.tan(Math.PI / 6));
    const calibration = { width: 640, height: 480, fx: focal, fy: focal, cx: 319.5, cy: 239.5 };
    const { markers } = await track(grey(), { calibration: JSON.stringify(calibration) });
    expect(markers!.elements[0]!.pose!.position!.z).toBeCloseTo(-1, 1);
    expect((await track(grey(), { calibration: '{}' })).error).toContain('"width"');
    const wide = JSON.stringify({ ...calibration, width: 1280, height: 720 });
    expect((await track(grey(), { calibration: wide })).error).toContain('1280 × 720');
    expect((await track(grey(), { calibration: undefined })).error).toBe('');
  });

  it('says once that it assumes a field of view', async () => {
    const lines: string[] = [];
    const fresh = await driveWithVision(markerTracking, { log: lines });
    for (let run = 0; run < 2; run++) await fresh.run(1000, { image: grey() }, ['image']);
    expect(lines.filter((line) => line.includes('field of view of 60°'))).toHaveLength(1);
  }, 60_000);

  it('says once what is wrong with an image, and continues with the next', async () => {
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    expect((await track(broken)).error).toMatch(/7 bytes/);
    expect(await track(broken)).toEqual({});
    expect(await track(grey())).toMatchObject({ error: '' });
    const cut = { ...jpeg(), data: jpeg().data.slice(0, 400) };
    expect((await track(cut)).error).toMatch(/damaged/i);
    await track(grey());
  });

  it('names the dictionaries when it does not know one, and the ids that there are', async () => {
    expect((await track(grey(), { dictionary: 'mine' })).error).toContain('aruco_4x4_50');
    const { error } = await track(grey(), { dictionary: undefined, ids: { elements: [99] } });
    expect(error).toContain('0 to 49');
    await track(grey(), { ids: undefined });
  });

  it('gives its results the time at which the image was taken, and drops images beyond its rate', async () => {
    const timestamp = { seconds: 1_800_000_000, nanos: 250_000_000 };
    await track(new Sample(grey(), { timestamp }));
    expect(module.outputs['markers']).toMatchObject({ timestamp });
    expect(module.outputs['outlines']).toMatchObject({ timestamp });
    await track(grey(), { maxRate: 2 });
    expect(await module.run(100, {}, ['image'])).toEqual({});
    expect(await module.run(1000, { smoothingMs: 5 }, ['smoothingMs'])).toEqual({});
  });
});
