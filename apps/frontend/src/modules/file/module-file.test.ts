import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { exportModule, exportModules, importModules } from './module-file.ts';

const [mirror] = aSession().processingModules;

describe('a module as a file', () => {
  it('holds what people made, and comes back so', () => {
    const file = exportModule({ ...mirror!, nodeId: 'n', status: 2 });
    expect(file.name).toBe('mirror.pm');
    expect(file.text).not.toMatch(/"status"|"nodeId"|"sessionId"|"id"/);
    expect(importModules(file)).toMatchObject({
      kind: 'read',
      modules: [
        {
          name: 'mirror',
          id: '',
          onProcessingStringified: '() => ({})',
          inputs: mirror!.inputs,
        },
      ],
    });
  });

  it('may hold several', () => {
    const file = exportModules([mirror!, { ...mirror!, name: 'other' }]);
    expect(file.name).toBe('modules.pm');
    expect(importModules(file)).toMatchObject({
      modules: [{ name: 'mirror' }, { name: 'other' }],
    });
  });

  it.each([
    ['{ "name": ', 'x.pm, line 1: Expected a value, found the end of the text.'],
    ['{}', 'x.pm contains a module without a name. Add a name.'],
    ['{ "name": [] }', 'x.pm: name must be'],
  ])('says why %j is none', (text, message) => {
    const read = importModules({ name: 'x.pm', text });
    expect(read).toMatchObject({ kind: 'broken', message: expect.stringContaining(message) });
  });
});
