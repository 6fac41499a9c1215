import { expect, it } from 'vitest';
import { aGraphOf, aModule } from '../model/testing/small-graph.ts';
import { placesOf } from './places.ts';

/** Drawn size of topic nodes with a picture, pixels. */
const PICTURE_TOPIC = { width: 174, height: 164 };

it('leaves room for the picture of a topic whose format only its wires tell', () => {
  const detection = aModule('detection', { image: 'image2D', threshold: 'double' });
  const graph = aGraphOf([detection], {
    'detection.image': '/image',
    'detection.threshold': '/threshold',
  });
  const places = placesOf(graph);
  const [image, threshold] = [places.get('topic:/image')!, places.get('topic:/threshold')!];
  expect(image.x).toBe(threshold.x);
  const gap =
    image.y < threshold.y
      ? threshold.y - image.y - PICTURE_TOPIC.height
      : image.y - threshold.y - 70;
  expect(gap).toBeGreaterThan(0);
});
