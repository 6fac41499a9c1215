import { expect, it } from 'vitest';
import { resultPlace, returnPlace } from './return-place.ts';

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

it('of an output is where the result names it', () => {
  const text = `onProcessing = (dt, inputs, state) => {
  state.reslt = { reslt: 'reslt: 1' };
  if (!inputs.a) return;
  return {
    outputs: { result: 1, reslt: 2 },
  };
};`;
  const place = (message: string) => resultPlace(text, 'onProcessing', message);
  expect(place('Output "reslt" is not declared.')).toEqual({ line: 5, column: 27 });
  expect(place('Output "result": write { double: value }.')).toEqual({ line: 5, column: 16 });
  expect(place('Output "other" is not declared.')).toEqual({ line: 4, column: 3 });
  expect(place('onProcessing must return an object.')).toEqual({ line: 4, column: 3 });
});

it('of an output may be before the return, or in a function without a body', () => {
  const before = `onProcessing = () => {
  const outputs = { reslt: 1 };
  return { outputs };
};`;
  const message = 'Output "reslt" is not declared.';
  expect(resultPlace(before, 'onProcessing', message)).toEqual({ line: 2, column: 21 });
  const short = 'onProcessing = () => ({ outputs: { reslt: 1 } });';
  expect(resultPlace(short, 'onProcessing', message)).toEqual({ line: 1, column: 36 });
});
