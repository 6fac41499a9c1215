import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Combines two numbers into one vector. A component without a record is 0. */
export const mergeVector2 = defineProcessingModule({
  name: 'merge-vector2',
  description: 'Combines x and y into a vector.',
  tags: ['vector', 'number', 'merge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    x: { format: 'double', description: 'First component; 0 without a value.' },
    y: { format: 'double', description: 'Second component; 0 without a value.' },
  },
  outputs: {
    vector: { format: 'vector2', description: 'The vector, in the unit of its components.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    if (!inputs.x && !inputs.y) return undefined;
    const [x = 0, y = 0] = [inputs.x, inputs.y].map(
      (record?: NumberRecord) => record?.double ?? record?.float ?? record?.int32,
    );
    if (![x, y].every(Number.isFinite)) return undefined;
    return { outputs: { vector: { vector2: { x, y } } } };
  },
});

/** Combines three numbers into one vector. A component without a record is 0. */
export const mergeVector3 = defineProcessingModule({
  name: 'merge-vector3',
  description: 'Combines x, y and z into a vector.',
  tags: ['vector', 'number', 'merge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    x: { format: 'double', description: 'First component; 0 without a value.' },
    y: { format: 'double', description: 'Second component; 0 without a value.' },
    z: { format: 'double', description: 'Third component; 0 without a value.' },
  },
  outputs: {
    vector: { format: 'vector3', description: 'The vector, in the unit of its components.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    if (!inputs.x && !inputs.y && !inputs.z) return undefined;
    const [x = 0, y = 0, z = 0] = [inputs.x, inputs.y, inputs.z].map(
      (record?: NumberRecord) => record?.double ?? record?.float ?? record?.int32,
    );
    if (![x, y, z].every(Number.isFinite)) return undefined;
    return { outputs: { vector: { vector3: { x, y, z } } } };
  },
});

/** Combines four numbers into one vector. A component without a record is 0. */
export const mergeVector4 = defineProcessingModule({
  name: 'merge-vector4',
  description: 'Combines x, y, z and w into a vector.',
  tags: ['vector', 'number', 'merge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    x: { format: 'double', description: 'First component; 0 without a value.' },
    y: { format: 'double', description: 'Second component; 0 without a value.' },
    z: { format: 'double', description: 'Third component; 0 without a value.' },
    w: { format: 'double', description: 'Fourth component; 0 without a value.' },
  },
  outputs: {
    vector: { format: 'vector4', description: 'The vector, in the unit of its components.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    if (!inputs.x && !inputs.y && !inputs.z && !inputs.w) return undefined;
    const [x = 0, y = 0, z = 0, w = 0] = [inputs.x, inputs.y, inputs.z, inputs.w].map(
      (record?: NumberRecord) => record?.double ?? record?.float ?? record?.int32,
    );
    if (![x, y, z, w].every(Number.isFinite)) return undefined;
    return { outputs: { vector: { vector4: { x, y, z, w } } } };
  },
});
