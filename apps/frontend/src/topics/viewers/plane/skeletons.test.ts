import { expect, it } from 'vitest';
import type { PlaneShape } from './plane-shapes.ts';
import { bonesOf } from './skeletons.ts';

const points = (...names: string[]): PlaneShape[] =>
  names.map((name, index) => ({ key: String(index), name, x: index / 10, y: 0.5 }));
const joined = (shapes: readonly PlaneShape[]): string[] =>
  bonesOf(shapes).map(([from, to]) => `${from.key} ${from.name} - ${to.key} ${to.name}`);

it('joins the keypoints of a body that are there', () => {
  expect(joined(points('leftShoulder', 'leftElbow', 'leftWrist', 'rightKnee'))).toEqual([
    '0 leftShoulder - 1 leftElbow',
    '1 leftElbow - 2 leftWrist',
  ]);
});

it('keeps two left hands apart', () => {
  const hands = points('left.wrist', 'left.thumbCmc', 'left.wrist', 'left.thumbCmc');
  expect(joined(hands)).toEqual([
    '0 left.wrist - 1 left.thumbCmc',
    '2 left.wrist - 3 left.thumbCmc',
  ]);
});

it('joins neither boxes nor points with other names', () => {
  const box = { ...points('leftElbow')[0]!, size: { width: 0.1, height: 0.1 } };
  expect(joined([...points('nose', 'tip'), box])).toEqual([]);
});
