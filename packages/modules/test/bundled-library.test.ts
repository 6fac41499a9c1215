import { runInNewContext } from 'node:vm';
import type { ProcessingModule } from '@ubii/proto';
import { build } from 'esbuild';
import { expect, it } from 'vitest';
import { freeNames } from './free-names.ts';

/** Bundling and checking types take their time on a busy machine. */
const TIMEOUT_MS = 30_000;

type Library = { moduleLibrary(): ProcessingModule[] };

/** The library as an application ships it. */
async function bundle(options: { minify: boolean; keepNames: boolean }): Promise<Library> {
  const { outputFiles } = await build({
    entryPoints: [`${import.meta.dirname}/../src/index.ts`],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'library',
    target: 'es2022',
    ...options,
  });
  const text = `${outputFiles[0]!.text}\nlibrary;`;
  return runInNewContext(text, { TextEncoder, TextDecoder, performance }) as Library;
}

it.each([
  ['as it is', { minify: false, keepNames: false }],
  ['minified', { minify: true, keepNames: false }],
  ['with names kept', { minify: false, keepNames: true }],
])(
  'source texts survive a bundler %s',
  async (_how, options) => {
    const { moduleLibrary } = await bundle(options);
    const modules = moduleLibrary();
    const sources = new Map(modules.map((m) => [m.name, m.onProcessingStringified]));
    const free = [...freeNames(sources)].flatMap(([, names]) => [...names]);
    expect(new Set(free)).toEqual(new Set(['performance', 'console']));
    const mirror = runInNewContext(`(${sources.get('mirror-pointer')}\n)`) as (
      ...args: unknown[]
    ) => unknown;
    expect(mirror(0, { pointer: { vector2: { x: 0.25, y: 0 } } }, {})).toMatchObject({
      outputs: { mirrored: { vector2: { x: 0.25, y: 0 } } },
    });
  },
  TIMEOUT_MS,
);
