import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { temporaryFolder } from '@ubii/program/testing';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it, vi } from 'vitest';

import { MemoryDocuments, MemoryStorage, RecordingLog } from '../../testing/index.ts';
import { LayeredDocuments } from './open-original.ts';
import { MAX_FILES, refuseOriginal, type OriginalFile } from './original-files.ts';
import { openOriginal } from './open-original.ts';
import { foldersOf, readOriginal } from './read-original.ts';

/** A module as classes of the original are written. */
const CLASS = `const { MSG_TYPES } = require('@tum-far/ubii-msg-formats');
const namida = require('@tum-far/namida/src/namida');
const { ProcessingModule } = require('../../src/processing/processingModule.js');

class Tripler extends ProcessingModule {
  static specs = {
    name: 'tripler',
    tags: ['numbers'],
    inputs: [{ internalName: 'in', messageFormat: MSG_TYPES.DATASTRUCTURE_DOUBLE }],
    outputs: [{ internalName: 'out', messageFormat: MSG_TYPES.DATASTRUCTURE_DOUBLE }],
    processingMode: { triggerOnInput: {} }
  };
  constructor(specs) {
    super(specs);
    Object.assign(this, Tripler.specs);
  }
  onCreated() {
    this.state.factor = 3;
    namida.log('Tripler', 'created');
  }
  times(value) {
    return value * this.state.factor;
  }
  onProcessing(deltaTime, inputs, state) {
    return { outputs: { out: { double: this.times(inputs.in.double) } } };
  }
} // the end`;

function folderWith(files: Readonly<Record<string, string>>): string {
  const folder = temporaryFolder();
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
  return folder;
}

function partsWith(log: RecordingLog) {
  return {
    sandboxes: createInlineSandboxes(),
    log,
    library: new Set(['counter']),
    clock: new FakeClock(),
  };
}

async function read(files: Readonly<Record<string, string>>) {
  const log = new RecordingLog();
  const folder = folderWith(files);
  const data = await readOriginal(await foldersOf(folder), partsWith(log));
  return { folder, log, ...data };
}

function faultOf([file]: readonly OriginalFile[]): string | undefined {
  return file?.document.fault;
}

const session = (name: string) => JSON.stringify({ name, processingModules: [] });
const exported = `${CLASS}\nmodule.exports = Tripler;`;

describe('the data of an original installation [SE-28]', () => {
  it.each(['database/', ''])('is read of the folder %j', async (base) => {
    const { sessions, modules, log } = await read({
      [`${base}sessions/b.session`]: session('b'),
      [`${base}sessions/a.session`]: session('a'),
      [`${base}sessions/.DS_Store`]: 'x',
      [`${base}sessions/notes.txt`]: 'x',
      [`${base}processing/m.pm`]: JSON.stringify({ name: 'm', onProcessingStringified: '() => 1' }),
      [`${base}processing/tripler.js`]: exported,
    });
    expect(sessions.map(({ document }) => document.json)).toMatchObject([
      { name: 'a' },
      { name: 'b' },
    ]);
    expect(modules.map(({ document }) => document.json)).toMatchObject([
      { name: 'm' },
      { name: 'tripler' },
    ]);
    expect(log.lines).toContainEqual(
      expect.objectContaining({
        fields: expect.objectContaining({ sessions: 2, modules: 2, unreadable: 0 }) as object,
      }),
    );
  });

  it('stays as it is', async () => {
    const { folder } = await read({ 'processing/t.js': exported, 'sessions/a.session': '{' });
    expect(readdirSync(folder).sort()).toEqual(['processing', 'sessions']);
    expect(readFileSync(join(folder, 'processing/t.js'), 'utf8')).toBe(exported);
  });

  it.each([
    ['sessions/a.session', '{ "name": ', /JSON/],
    ['sessions/a.session', '[]', /JSON object/],
    ['sessions/a.session', '{ "name": "a", "interactions": [] }', /interactions/],
    ['sessions/a.session', `"${'x'.repeat(8 * 1024 * 1024)}"`, /at most 8388608/],
    ['processing/a.pm', 'name: x', /JSON/],
    ['processing/a.js', 'module.exports = class {', /./],
    ['processing/a.js', "throw new Error('at home')", /at home/],
    [
      'processing/a.js',
      "require('fs').rmSync('/')",
      /requires "fs", which a sandbox does not have\.$/,
    ],
    ['processing/a.js', 'exports.specs = {}', /exports no class/],
    ['processing/a.js', 'module.exports = class { onProcessing() {} }', /no name/],
    ['processing/a.js', "module.exports = class { name = 'x' }", /no method onProcessing/],
    ['processing/a.js', `//${'x'.repeat(200 * 1024)}`, /at most 204800 are read of a script/],
  ])('names %s with the reason, and reads the others: %.30s', async (path, text, reason) => {
    const other = path.replace('a.', 'b.').replace('.js', '.pm');
    const { sessions, modules, folder } = await read({ [path]: text, [other]: session('b') });
    const files = path.startsWith('sessions') ? sessions : modules;
    expect(files.map((file) => file.path)).toEqual([join(folder, path), join(folder, other)]);
    expect(faultOf(files)).toMatch(reason);
    expect(files[1]?.document.json).toMatchObject({ name: 'b' });
  });

  it('has one session for a name, and a limited number of files', async () => {
    const twice = await read({
      'sessions/a.session': session('x'),
      'sessions/b.session': session('x'),
    });
    expect(twice.sessions[1]?.document.fault).toMatch(/a\.session already/);
    const names = Array.from({ length: MAX_FILES + 3 }, (_, index) => `sessions/${index}.session`);
    const many = await read(Object.fromEntries(names.map((name) => [name, session(name)])));
    expect(many.sessions.filter(({ document }) => document.fault === undefined)).toHaveLength(
      MAX_FILES,
    );
    expect(many.sessions.at(-1)).toMatchObject({
      path: join(many.folder, 'sessions'),
      document: { fault: expect.stringContaining('1003 files') as string },
    });
  });

  it('does not delay the start forever by scripts that never end, and names what it left out', async () => {
    const log = new RecordingLog();
    const parts = partsWith(log);
    // Each script takes the time after which it is ended.
    const sandboxes: typeof parts.sandboxes = {
      ...parts.sandboxes,
      open(...args) {
        parts.clock.advanceSync(500);
        return parts.sandboxes.open(...args);
      },
    };
    const scripts = Array.from({ length: 50 }, (_, index) => {
      const number = String(index).padStart(2, '0');
      return [`processing/${number}.js`, "throw new Error('too long')"] as const;
    });
    const folder = folderWith({
      ...Object.fromEntries(scripts),
      'processing/last.pm': JSON.stringify({ name: 'last' }),
    });
    const { modules } = await readOriginal(await foldersOf(folder), { ...parts, sandboxes });
    const leftOut = modules.filter(({ document }) => document.fault?.includes('was not read'));
    expect(leftOut.map(({ path }) => path)).toEqual(
      scripts.slice(40).map(([name]) => join(folder, name)),
    );
    expect(modules.at(-1)?.document.json).toEqual({ name: 'last' });
    expect(log.lines).toContainEqual(
      expect.objectContaining({
        level: 'warn',
        fields: { folder: join(folder, 'processing'), count: 10, seconds: 20 },
      }),
    );
  });

  it('has its own code in its sessions for modules with the name of one of this master', async () => {
    const code = '() => ({ outputs: { count: { int32: 1 } } })';
    const other = { name: 'counter', onProcessingStringified: '() => ({})' };
    const { sessions, log } = await read({
      'processing/counter.pm': JSON.stringify({
        name: 'counter',
        outputs: [{ internalName: 'count', messageFormat: 'int32' }],
        onProcessingStringified: code,
      }),
      'sessions/a.session': JSON.stringify({
        name: 'a',
        processingModules: [{ name: 'counter', inputs: [], status: 0 }, other, { name: 'x' }, null],
      }),
    });
    expect(sessions[0]?.document.json).toEqual({
      name: 'a',
      processingModules: [
        {
          name: 'counter',
          outputs: [{ internalName: 'count', messageFormat: 'int32' }],
          onProcessingStringified: code,
        },
        other,
        { name: 'x' },
        null,
      ],
    });
    expect(log.lines).toContainEqual(
      expect.objectContaining({ level: 'warn', fields: { module: 'counter' } }),
    );
  });

  it('cannot be the data directory, whose files the master writes', async () => {
    const original = folderWith({ 'sessions/a.session': '{}', 'processing/a.pm': '{}' });
    await expect(refuseOriginal(original)).rejects.toThrow('--original-data');
    await expect(
      refuseOriginal(folderWith({ 'database/sessions/a.session': '' })),
    ).rejects.toThrow();
    await expect(refuseOriginal(folderWith({ 'sessions/a.session': '' }))).resolves.toBeUndefined();
    await expect(refuseOriginal(join(original, 'not-there'))).resolves.toBeUndefined();
  });

  it('counts at once when a file is changed by hand', async () => {
    const storage = new MemoryStorage();
    const folder = folderWith({ 'sessions/a.session': '{', 'processing/b.pm': '{}' });
    expect(await openOriginal(storage, undefined, partsWith(new RecordingLog()))).toBe(storage);
    const { sessions } = await openOriginal(storage, folder, partsWith(new RecordingLog()));
    const told: (readonly string[])[] = [];
    sessions.onChange((keys) => told.push(keys));
    const isBroken = () =>
      [...sessions.documents().values()].map(({ fault }) => fault !== undefined);
    expect(isBroken()).toEqual([true]);
    writeFileSync(join(folder, 'sessions/a.session'), session('repaired'));
    await vi.waitFor(() => expect(isBroken()).toEqual([false]), { timeout: 20_000 });
    expect(told).toEqual([[expect.stringContaining('a.session') as string]]);
    sessions.close();
  });

  it('has to be there', async () => {
    await expect(read({ 'package.json': '{}' })).rejects.toThrow('--original-data');
  });
});

describe('documents over those of an original installation [SE-28]', () => {
  const file = (name: string): OriginalFile => ({
    path: `/db/sessions/${name}.session`,
    document: { json: { name, tags: [] } },
  });
  const [broken, nameless] = [
    { path: '/db/sessions/b.session', document: { fault: 'it is not JSON' } },
    { path: '/db/sessions/no-name.session', document: { json: {} } },
  ];

  it('are both, and a change is a document of the master', async () => {
    const own = new MemoryDocuments();
    const store = new LayeredDocuments(own, [file('a'), broken, nameless]);
    await own.write('mine', { name: 'mine' });
    const documents = store.documents();
    expect(store.documents()).toBe(documents);
    expect([...documents.values()]).toEqual([
      { json: { name: 'mine' } },
      file('a').document,
      broken.document,
      { json: { name: 'no-name' } },
    ]);
    const [, key] = [...documents.keys()];
    expect(store.describe(key!)).toBe('/db/sessions/a.session');
    await store.write(key!, { name: 'a', tags: ['changed'] });
    expect(own.documents().get('a')).toEqual({ json: { name: 'a', tags: ['changed'] } });
    expect(store.documents().has(key!)).toBe(false);
    await expect(store.delete(key!)).rejects.toMatchObject({ code: 'failed_precondition' });
    await store.delete('a');
    expect(store.documents().get(key!)).toEqual(file('a').document);
  });
});
