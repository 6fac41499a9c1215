import { describe, expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { sessionSpec } from '../text/session-spec.ts';
import { FILE_LIMITS } from './file-limits.ts';
import { readSessionFile, refuseSize } from './read-session-file.ts';
import { exportSession } from './session-file.ts';

/** Returns the error message for a text; undefined for a session. */
function refusal(text: string): string | undefined {
  const read = readSessionFile({ name: 'a.json', text });
  return read.kind === 'broken' ? read.message : undefined;
}

describe('a file that was exported', () => {
  it('comes back as the session it was', () => {
    const file = exportSession(sessionSpec(aSession()));
    const read = readSessionFile(file);
    expect(read).toMatchObject({ kind: 'read', problems: [], session: { name: 'Two hands' } });
    if (read.kind === 'read') expect(exportSession(sessionSpec(read.session))).toEqual(file);
  });

  it('is called like its file when it has no name', () => {
    const read = readSessionFile({ name: 'Old one.session', text: '{"processingModules":[]}' });
    expect(read).toMatchObject({ kind: 'read', session: { name: 'Old one' } });
  });
});

describe('a file that is no session', () => {
  it.each([
    ['', 'a.json is empty.'],
    ['PNG\0\0', 'a.json is not a text file'],
    ['[]', 'contains no session'],
    ['7', 'contains no session'],
    ['{"name":"x"}', 'it has neither modules nor mappings'],
    ['{\n"processingModules": [\n{,}]}', 'a.json, line 3: '],
    ['{"processingModules":7}', 'a.json, line 1: '],
  ])('is named with the place: %j', (text, words) => {
    expect(refusal(text)).toContain(words);
  });

  it.each([
    [[{ id: 'a', type: 'inject', z: 'f', wires: [[]] }], 'a Node-RED flow'],
    [{ nodes: [], links: [], version: 0.4 }, 'a ComfyUI workflow'],
    [{ 3: { class_type: 'KSampler', inputs: {} } }, 'a ComfyUI workflow'],
    [{ ops: [{ objName: 'Ops.Gl.MainLoop' }] }, 'a cables.gl patch'],
    [{ name: 'm', onProcessingStringified: '() => {}' }, 'a module file'],
    [{ format: 'ubi-interact.nodes', version: 1, nodes: [] }, 'nodes copied from a graph'],
    [[{ name: 's', processingModules: [] }], 'a list of sessions'],
  ])('is recognised: %j', (value, what) => {
    const text = JSON.stringify(value);
    expect(refusal(text)).toContain(`a.json is ${what}, not a session.`);
  });

  it('can be put right by hand when it was meant as one', () => {
    const broken = readSessionFile({ name: 'a.json', text: '{"processingModules": [' });
    expect(broken).toMatchObject({ kind: 'broken', text: '{"processingModules": [' });
    expect(readSessionFile({ name: 'a.json', text: '[]' })).toMatchObject({ text: undefined });
  });
});

describe('a file that is too much', () => {
  it('is not even read', () => {
    expect(refuseSize('a.json', FILE_LIMITS.bytes)).toBeUndefined();
    expect(refuseSize('a.json', 50 * 1024 * 1024)).toMatchObject({
      kind: 'broken',
      message: expect.stringContaining('a.json has 50 MB.') as string,
    });
  });

  it('says how many modules or mappings there are, and how many there may be', () => {
    const processingModules = Array.from({ length: 300 }, () => ({ name: 'low-pass' }));
    expect(refusal(JSON.stringify({ processingModules }))).toContain(
      '300 modules; a session has at most 256',
    );
    const inputMappings = Array.from({ length: 5_000 }, () => ({ inputName: 'a', topic: '/a' }));
    expect(refusal(JSON.stringify({ ioMappings: [{ inputMappings }] }))).toContain(
      '5\u00a0000 mapped inputs and outputs; a session has at most 4\u00a0096',
    );
  });
});
