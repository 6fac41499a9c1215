import { ProcessingModuleLanguage } from '@ubii/proto';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it, onTestFinished } from 'vitest';
import { loadModuleFolder, watchModuleFolder, type LoadedFolder } from './index.ts';

function folderWith(files: Readonly<Record<string, string>>): string {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-modules-'));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
  return folder;
}

const definition = `export default {
  name: 'mirror', inputs: { in: 'vector2', all: { format: 'vector2', list: true } }, outputs: { out: 'vector2' },
  mode: { triggerOnInput: { minDelayMs: 5 } },
  onProcessing(deltaTime, inputs, state) { return { outputs: { out: { vector2: inputs.in.vector2 } } }; },
};`;

const stored = JSON.stringify({
  name: 'stored',
  inputs: [{ internalName: 'in', messageFormat: 'ubii.dataStructure.Vector2' }],
  processingMode: { frequency: { hertz: 10 } },
  onProcessingStringified: '() => {}',
});

describe('a folder of modules', () => {
  it('[PM-51] holds definitions with functions and JSON with source text', async () => {
    const folder = folderWith({ 'mirror.mjs': definition, 'stored.pm': stored, 'README.md': 'x' });
    const { modules, problems } = await loadModuleFolder(folder);
    expect(problems).toEqual([]);
    expect(modules).toMatchObject([
      {
        name: 'mirror',
        language: ProcessingModuleLanguage.JS,
        inputs: [
          { internalName: 'in', messageFormat: 'ubii.dataStructure.Vector2' },
          { internalName: 'all', isRecordList: true },
        ],
        processingMode: { triggerOnInput: { minDelayMs: 5 } },
      },
      { name: 'stored', processingMode: { frequency: { hertz: 10 } } },
    ]);
    expect(modules[0]?.onProcessingStringified).toContain('inputs.in.vector2');
  });

  it('holds objects like a message, with functions, and lists of modules', async () => {
    const folder = folderWith({
      'many.mjs': `export default [
        { name: 'a', onProcessing: () => {} },
        { name: 'b', inputs: [{ internalName: 'x', messageFormat: 'double' }],
          processingMode: { frequency: { hertz: 3 } }, onProcessing: () => {} },
        { name: 'c', onProcessingStringified: '() => 1' },
      ];`,
    });
    const { modules, problems } = await loadModuleFolder(folder);
    expect(problems).toEqual([]);
    expect(modules).toMatchObject([
      { name: 'a', inputs: [] },
      {
        name: 'b',
        inputs: [{ internalName: 'x', messageFormat: 'double' }],
        processingMode: { frequency: { hertz: 3 } },
      },
      { name: 'c', onProcessingStringified: '() => 1' },
    ]);
  });

  it.each([
    ['text.pm', '{ "name": ', /JSON/],
    ['list.pm', '[]', /./],
    ['no-code.pm', '{ "name": "x" }', /onProcessing/],
    ['member.pm', '{ "inputs": 3 }', /inputs/],
    ['nameless.mjs', 'export default { onProcessing: () => {} }', /needs a name/],
    ['no-default.mjs', 'export const x = 1', /default export/],
    ['syntax.mjs', 'export default {', /./],
    ['throws.mjs', 'throw new Error("at home")', /at home/],
    ['class.mjs', 'export default class {}', /a function or class/],
  ])('names %s with the reason, and loads the others', async (file, content, reason) => {
    const { modules, problems } = await loadModuleFolder(
      folderWith({ [file]: content, 'good.mjs': definition }),
    );
    expect(modules.map(({ name }) => name)).toEqual(['mirror']);
    expect(problems).toMatchObject([{ file, message: expect.stringMatching(reason) as string }]);
  });

  it('says where a module is twice', async () => {
    const { modules, problems } = await loadModuleFolder(
      folderWith({ 'a.mjs': definition, 'b.mjs': definition }),
    );
    expect(modules).toHaveLength(1);
    expect(problems).toMatchObject([{ file: 'b.mjs', message: /already defined in a.mjs/ }]);
  });

  it('that is not there is an error', async () => {
    const folder = join(folderWith({}), 'missing');
    await expect(loadModuleFolder(folder)).rejects.toThrow(/ENOENT/);
    await expect(watchModuleFolder(folder, ignore, ignore)).rejects.toThrow(/ENOENT/);
  });

  it('is read again when files change, come and go', async () => {
    const folder = folderWith({ 'mirror.mjs': definition });
    let tell: (loaded: LoadedFolder) => void = ignore;
    const next = () => new Promise<LoadedFolder>((resolve) => (tell = resolve));
    const watched = await watchModuleFolder(folder, (loaded) => tell(loaded), ignore);
    onTestFinished(watched.close);
    expect(watched.loaded.modules.map(({ name }) => name)).toEqual(['mirror']);
    const changed = next();
    writeFileSync(join(folder, 'mirror.mjs'), definition.replace("'mirror'", "'mirrored'"));
    expect((await changed).modules.map(({ name }) => name)).toEqual(['mirrored']);
    const added = next();
    writeFileSync(join(folder, 'stored.pm'), stored);
    expect((await added).modules.map(({ name }) => name)).toEqual(['mirrored', 'stored']);
    const removed = next();
    rmSync(join(folder, 'mirror.mjs'));
    expect((await removed).modules.map(({ name }) => name)).toEqual(['stored']);
  });
});

function ignore(): void {}
