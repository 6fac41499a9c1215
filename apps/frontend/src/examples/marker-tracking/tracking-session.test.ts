import { markerTracking } from '@ubii/modules';
import { expect, it } from 'vitest';
import { trackingSession } from './tracking-session.ts';

const SPEC = {
  owner: 'Anna',
  image: '/a/image',
  outputs: {
    markers: '/a/markers',
    outlines: '/a/outlines',
    decodeMs: '/a/decode',
    durationMs: '/a/ms',
    error: '/a/error',
  },
  dictionary: 'aruco_4x4_50',
  sizeMetres: 0.06,
  smoothingMs: 0,
  calibration: '',
};

it('maps inputs and outputs that the module has', () => {
  const [mapping] = trackingSession(SPEC).ioMappings!;
  const inputs = mapping!.inputMappings!.map(({ inputName }) => inputName!);
  const outputs = mapping!.outputMappings!.map(({ outputName }) => outputName!);
  expect(Object.keys(markerTracking.inputs)).toEqual(expect.arrayContaining(inputs));
  expect(Object.keys(markerTracking.outputs).sort()).toEqual(outputs.sort());
  expect(inputs).not.toContain('calibration');
});

it('hands a calibration on as it is', () => {
  const calibration = '{"width":640}';
  const [mapping] = trackingSession({ ...SPEC, calibration }).ioMappings!;
  const input = mapping!.inputMappings!.find(({ inputName }) => inputName === 'calibration');
  expect(input!.constantJson).toBe(JSON.stringify({ string: calibration }));
});
