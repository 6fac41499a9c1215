import { cameraCalibration } from '@ubii/modules';
import { DEFAULT_BOARD } from '@ubii/vision/markers';
import { expect, it } from 'vitest';
import { CALIBRATION_COMPONENTS, calibrationSession } from './calibration-session.ts';
import { calibrationWords } from './calibration-words.ts';

it('maps inputs and outputs that the module has, to components of the page', () => {
  const [mapping] = calibrationSession('Anna', DEFAULT_BOARD, (name) => `/a/${name}`).ioMappings!;
  const inputs = mapping!.inputMappings!.map(({ inputName }) => inputName!);
  const outputs = mapping!.outputMappings!.map(({ outputName }) => outputName!);
  expect(Object.keys(cameraCalibration.inputs)).toEqual(expect.arrayContaining(inputs));
  expect(Object.keys(cameraCalibration.outputs).sort()).toEqual(outputs.sort());
  const topics = [...mapping!.inputMappings!, ...mapping!.outputMappings!].flatMap(({ topic }) =>
    topic ? [topic] : [],
  );
  expect(topics.sort()).toEqual(CALIBRATION_COMPONENTS.map(({ name }) => `/a/${name}`).sort());
});

it.each([
  [0.3, 'Good'],
  [0.8, 'Fair'],
  [1.7, 'Poor'],
])('calls an error of %s pixels %s', (reprojectionErrorPx, word) => {
  const camera = { width: 640, height: 480, fx: 554.26, fy: 554, cx: 320, cy: 240, distortion: [] };
  const words = calibrationWords({ ...camera, reprojectionErrorPx, views: 12 });
  expect(words.quality).toBe(word);
  expect(words.facts).toContainEqual({ name: 'Field of view', value: '60.0° × 46.8°' });
});
