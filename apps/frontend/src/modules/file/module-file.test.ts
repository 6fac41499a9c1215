import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { exportModule, importModule } from './module-file.ts';

const [mirror] = aSession().processingModules;

describe('a module as a file', () => {
  it('holds what people made, and comes back so', () => {
    const file = exportModule({ ...mirror!, nodeId: 'n', status: 2 });
    expect(file.name).toBe('mirror.pm');
    expect(file.text).not.toMatch(/"status"|"nodeId"|"sessionId"|"id"/);
    expect(importModule(file)).toMatchObject({
      kind: 'read',
      module: {
        name: 'mirror',
        id: '',
        onProcessingStringified: '() => ({})',
        inputs: mirror!.inputs,
      },
    });
  });

  it.each([
    ['{ "name": ', 'x.pm, line 1: A value is expected, but here is the end of the text.'],
    ['{}', 'x.pm holds no module: it has no name.'],
    ['{ "name": [] }', 'x.pm: name must be'],
  ])('says why %j is none', (text, message) => {
    const read = importModule({ name: 'x.pm', text });
    expect(read).toMatchObject({ kind: 'broken', message: expect.stringContaining(message) });
  });
});
