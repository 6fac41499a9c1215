import { expect, it } from 'vitest';

import { object2DListOfDetections, object2DListOfKeypoints } from './detection-messages.ts';

it('a detection becomes a box with the class as its id', () => {
  const box = { x: 0.25, y: 0.5, width: 0.2, height: 0.1 };
  expect(object2DListOfDetections([{ class: 'cup', score: 0.46789, box }])).toEqual({
    elements: [
      {
        id: 'cup',
        pose: { position: { x: 0.25, y: 0.5 } },
        size: { x: 0.2, y: 0.1 },
        userDataJson: '{"score":0.47}',
      },
    ],
  });
});

it('keypoints become points, without those of a low score', () => {
  const keypoints = [
    { name: 'nose', x: 0.4, y: 0.3, score: 0.9 },
    { name: 'leftKnee', x: 0.6, y: 0.9, score: 0.1 },
  ];
  const point = {
    id: 'nose',
    pose: { position: { x: 0.4, y: 0.3 } },
    userDataJson: '{"score":0.9}',
  };
  expect(object2DListOfKeypoints(keypoints, 0.3).elements).toEqual([point]);
  expect(object2DListOfKeypoints(keypoints).elements).toHaveLength(2);
  expect(object2DListOfKeypoints([{ name: 'wrist', x: 0, y: 0 }], 0.5).elements).toHaveLength(1);
});
