import { expect, it } from 'vitest';
import { typeWords } from './type-words.ts';

const io = (name: string, format: string) => ({ name, format, isList: false });
const MODULE = { inputs: [io('value', 'double')], outputs: [io('result', 'double')] };

it.each([
  [
    "Type 'number' is not assignable to type 'OutputValue<\"double\">'.\n  Type 'number' is not assignable to type '{ readonly double: number; }'.",
    'Write { double: value }, not a bare number.',
  ],
  [
    "Type '(d: number) => { outputs: { result: number; }; }' is not assignable to type '(deltaTimeMs: number) => void | Result | Promise<void | Result>'.\n  Type '{ outputs: { result: number; }; }' is not assignable to type 'void | Result | Promise<void | Result>'.\n    The types of 'outputs.result' are incompatible between these types.\n      Type 'number' is not assignable to type 'OutputValue<\"double\">'.",
    'Output "result": write { double: value }, not a bare number.',
  ],
  [
    "Object literal may only specify known properties, but 'reslt' does not exist in type 'Outputs'. Did you mean to write 'result'?",
    'Output "reslt" is not declared. Did you mean "result"?',
  ],
  [
    "Type '() => { outputs: { speed: number; }; }' is not assignable to type '() => void'.\n  Types of property 'outputs' are incompatible.\n    Type '{ speed: number; }' has no properties in common with type 'Outputs'.",
    'Output "speed" is not declared. Declared outputs: "result".',
  ],
  [
    "Object literal may only specify known properties, and 'x' does not exist in type 'OutputValue<\"vector2\">'.",
    'Write { vector2: { x, y } }, not { x }.',
  ],
  [
    "Property 'elements' is missing in type 'number[]' but required in type 'OutputList<\"double\">'.",
    'Write { elements: [{ double: value }, …] }, not an array.',
  ],
  [
    "Property 'valu' does not exist on type 'Inputs'. Did you mean 'value'?",
    'Input "valu" is not declared. Did you mean "value"?',
  ],
  [
    "'inputs.value' is possibly 'undefined'.",
    'inputs.value has no value until the first record. Return before you read it: if (!inputs.value) return;',
  ],
  [
    "Type 'number' is not assignable to type 'void | Result | Promise<void | Result>'.",
    'onProcessing must return { outputs: { … } }, not a bare number.',
  ],
  [
    "Type 'string' is not assignable to type 'number'.",
    "Type 'string' is not assignable to type 'number'.",
  ],
])('%s', (message, words) => {
  expect(typeWords(message, MODULE)).toBe(words);
});
