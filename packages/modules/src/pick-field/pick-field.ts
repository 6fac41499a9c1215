import { defineProcessingModule } from '@ubii/pm-sandbox';

/**
 * Extracts one field of a value: the height of a pose, one number of a list. It reads records of any
 * data format: a session can set another format for the input than the one here.
 */
export const pickField = defineProcessingModule({
  name: 'pick-field',
  description: 'Extracts a field of a value, such as position.x.',
  tags: ['field', 'convert', 'number', 'vector', 'text'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    value: {
      format: 'pose3D',
      description: 'The value with the field; a session can set another format.',
    },
    path: {
      format: 'string',
      description: 'Path of the field, such as position.x or elements[0]; empty: the whole value.',
    },
  },
  outputs: {
    number: {
      format: 'double',
      description: 'The field, if it is a number; true is 1, false is 0.',
    },
    isTrue: { format: 'bool', description: 'The field, if it is a boolean.' },
    text: { format: 'string', description: 'The field, if it is a text, number or boolean.' },
    vector2: { format: 'vector2', description: 'The field, if it has x and y.' },
    vector3: { format: 'vector3', description: 'The field, if it has x, y and z.' },
    vector4: { format: 'vector4', description: 'The field, if it has x, y, z and w.' },
    quaternion: {
      format: 'quaternion',
      description: 'The field as a rotation, if it has x, y, z and w.',
    },
    color: { format: 'color', description: 'The field, if it has r, g, b and a.' },
    error: { format: 'string', description: 'Problem with the path; empty when there is none.' },
  },
  mode: { triggerOnInput: {} },
  createState: () => ({ error: '' }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const read = {
      /** The field at the path, or the reason why there is none. */
      part(whole: unknown, path: string): { part: unknown } | { reason: string } {
        let part = whole;
        // elements[0].x and elements.0.x are the same; a leading $ is the whole value.
        for (const key of path.replace(/\[(\d+)\]/g, '.$1').split('.')) {
          if (key === '' || key === '$') continue;
          if (typeof part !== 'object' || part === null || !Object.hasOwn(part, key)) {
            return { reason: `The value has no "${path}": "${key}" is missing.` };
          }
          part = (part as { [key: string]: unknown })[key];
        }
        return { part };
      },
      /** The members by name, if all of them are finite numbers. */
      numbers<K extends string>(part: unknown, ...names: K[]): { [name in K]: number } | undefined {
        if (typeof part !== 'object' || part === null) return undefined;
        const all = part as { [name in K]?: unknown };
        const entries = names.map((name) => [name, all[name]] as const);
        if (!entries.every(([, value]) => Number.isFinite(value))) return undefined;
        return Object.fromEntries(entries) as { [name in K]: number };
      },
    };
    const record = inputs.value as { type: string; [member: string]: unknown } | undefined;
    if (record === undefined) return undefined;
    const result = read.part(record[record.type], inputs.path?.string.trim() ?? '');
    const error = 'reason' in result ? result.reason : '';
    const hasNewError = error !== state.error;
    state.error = error;
    const part = 'part' in result ? result.part : undefined;
    const number = typeof part === 'boolean' ? Number(part) : part;
    const vector2 = read.numbers(part, 'x', 'y');
    const vector3 = read.numbers(part, 'x', 'y', 'z');
    const vector4 = read.numbers(part, 'x', 'y', 'z', 'w');
    const color = read.numbers(part, 'r', 'g', 'b', 'a');
    const isText = typeof part === 'string' || typeof part === 'number' || part === !!part;
    return {
      outputs: {
        number: Number.isFinite(number) ? { double: number as number } : undefined,
        isTrue: typeof part === 'boolean' ? { bool: part } : undefined,
        text: isText ? { string: String(part) } : undefined,
        vector2: vector2 && { vector2 },
        vector3: vector3 && { vector3 },
        vector4: vector4 && { vector4 },
        quaternion: vector4 && { quaternion: vector4 },
        color: color && { color },
        error: hasNewError ? { string: error } : undefined,
      },
    };
  },
});
