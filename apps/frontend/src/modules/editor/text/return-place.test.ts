import { expect, it } from 'vitest';
import { returnPlace } from './return-place.ts';

it('is the last return with a value', () => {
  const text = `onCreated = () => {};

onProcessing = (dt, inputs) => {
  if (!inputs.a) {
    return { outputs: {} };
  }
  // return nothing
  const said = 'return';
  return { outputs: { speed: said } };
};`;
  expect(returnPlace(text, 'onProcessing')).toEqual({ line: 9, column: 3 });
  expect(returnPlace(text, 'onCreated')).toBeUndefined();
});

it('may be in the line of the name', () => {
  expect(returnPlace('onProcessing = () => { return 1; };', 'onProcessing')).toEqual({
    line: 1,
    column: 24,
  });
});

it('is unknown for a function without a body', () => {
  expect(returnPlace('onProcessing = () => ({ outputs: {} });', 'onProcessing')).toBeUndefined();
});
