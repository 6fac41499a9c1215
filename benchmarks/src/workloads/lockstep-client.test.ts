import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import { PassWatch } from './lockstep-client.ts';

const output = (topic: string, pass: number, input = 7): TopicRecord => ({
  topic,
  format: 'vector3',
  value: { x: pass, y: input, z: 0 },
  timestampMs: undefined,
  clientId: '',
});

describe('PassWatch', () => {
  it('counts complete passes', () => {
    const watch = new PassWatch(['/a', '/b'], 7);
    for (const pass of [4, 5, 6]) {
      watch.handleRecord(output('/a', pass));
      watch.handleRecord(output('/b', pass));
    }
    expect(watch.handleRecord(output('/c', 7))).toBe(false);
    expect(watch).toMatchObject({ passes: 3, faults: [] });
  });

  it('finds outputs that are missing, out of order or of a wrong input', () => {
    const watch = new PassWatch(['/a', '/b'], 7);
    watch.handleRecord(output('/a', 1));
    watch.handleRecord(output('/a', 2));
    watch.handleRecord(output('/b', 2, 8));
    expect(watch.faults).toEqual([
      'unexpected: output 0 of pass 2 where 1 of 1 was to come',
      'unexpected: a module found 8 instead of 7',
    ]);
  });
});
