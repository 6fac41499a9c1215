import { SessionState, type Init, type Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { sessionSpec } from './session-spec.ts';
import { problemsOnLines, readSessionText, sessionText } from './session-text.ts';
import { aSession } from '../testing/a-session.ts';

describe('a session as text', () => {
  it('is pretty, without what is empty and without what the master adds', () => {
    const session = aSession({ state: SessionState.SESSION_RUNNING });
    const text = sessionText(sessionSpec(session));
    expect(text.split('\n').slice(0, 4)).toEqual([
      '{',
      '  "name": "Two hands",',
      '  "processingModules": [',
      '    {',
    ]);
    expect(text).not.toMatch(/"status"|"sessionId"|"problems"|"state"|"revision"/);
    expect(text.endsWith('}\n')).toBe(true);
  });

  it('comes back as it was', () => {
    const spec = sessionSpec(aSession());
    const read = readSessionText(sessionText(spec));
    if (read.kind !== 'read') throw new Error('not read');
    expect(sessionSpec(read.session)).toEqual(spec);
    expect(read.problems).toEqual([]);
  });

  it('keeps a place people chose, not one the master chose [SE-31]', () => {
    const session = aSession();
    session.processingModules[0]!.nodeId = 'node';
    expect(sessionSpec(session).processingModules![0]!.nodeId).toBe('node');
    session.processingModules[0]!.extension!.replaceable = true;
    expect(sessionSpec(session).processingModules![0]!.nodeId).toBe('');
  });

  it.each([
    ['{\n  "name": \n}', { line: 3 }],
    ['[]', { line: 1, message: 'Expected a session as an object: { … }.' }],
    ['{\n"processingModules": [\n7]\n}', { line: 3 }],
    ['{\n"name": {}\n}', { line: 2 }],
  ])('says on which line %j is wrong', (text, problem) => {
    expect(readSessionText(text)).toMatchObject({ kind: 'broken', problems: [problem] });
  });

  it('names unknown members, so that typing errors are visible', () => {
    const text = '{\n  "name": "x",\n  "io_mappings": [\n    { "inputMapings": [] }\n  ]\n}';
    expect(readSessionText(text)).toMatchObject({
      kind: 'read',
      problems: [{ isError: false, line: 4, path: 'io_mappings[0].inputMapings' }],
    });
  });

  it('understands what old clients write [SE-6]', () => {
    const text = JSON.stringify({
      name: 'old',
      ioMappings: [{ inputMappings: [{ inputName: 'a', topicSource: { topic: '/a' } }] }],
    });
    expect(readSessionText(text)).toMatchObject({ kind: 'read', problems: [] });
  });

  it('shows each problem of the master on its line [SE-3]', () => {
    const spec: Init<Session> = sessionSpec(aSession());
    const text = sessionText(spec);
    const problem = {
      isError: true,
      code: 'unknown_input',
      message: 'There is no input "x".',
      path: 'ioMappings[0].inputMappings[0].inputName',
      moduleId: '',
      moduleName: '',
      nodeId: '',
      line: 0,
      column: 0,
    };
    const [found] = problemsOnLines(text, [problem]);
    expect(text.split('\n')[found!.line! - 1]).toContain('"inputName": "position"');
  });
});
