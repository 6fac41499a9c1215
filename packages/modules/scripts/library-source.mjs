import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import prettier from 'prettier';

const inSource = (path) => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

/**
 * What modules need of the sandbox when they are defined. With all of it, its names would change those
 * within the modules: a bundle has one name for one thing.
 */
const definingOnly = {
  name: 'defining only',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^@ubii\/pm-sandbox$/ }, () => ({ path: 'define', namespace: 'define' }));
    onLoad({ filter: /.*/, namespace: 'define' }, () => ({
      contents: 'export const defineProcessingModule = (definition) => definition;',
    }));
  },
};

/**
 * Text of src/generated/library.ts, made from the definitions as they are.
 *
 * @returns {Promise<string>}
 */
export async function librarySource() {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-library-'));
  try {
    const { MODULES } = await bundle(folder, 'modules', inSource('modules.ts'), [definingOnly]);
    const { moduleToWire, toJson } = await bundle(folder, 'tools', {
      contents: `export { moduleToWire } from '@ubii/pm-sandbox'; export { toJson } from '@ubii/proto';`,
      resolveDir: inSource('.'),
    });
    const library = MODULES.map((definition) =>
      stripped(toJson('ubii.processing.ProcessingModule', moduleToWire(definition))),
    );
    return await prettier.format(
      `// Made by \`pnpm --filter @ubii/modules generate\` from the definitions. Do not change it by hand.
import type { JsonObject } from '@ubii/proto';

/** Every module of the library as JSON, from a to z. */
export const LIBRARY: readonly JsonObject[] = ${JSON.stringify(library, null, 2)};
`,
      { ...(await prettier.resolveConfig(inSource('index.ts'))), parser: 'typescript' },
    );
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

async function bundle(folder, name, entry, plugins = []) {
  const outfile = join(folder, `${name}.mjs`);
  await build({
    ...(typeof entry === 'string' ? { entryPoints: [entry] } : { stdin: entry }),
    outfile,
    bundle: true,
    format: 'esm',
    platform: 'node',
    // What every node and browser that runs modules understands.
    target: 'es2022',
    plugins,
    logLevel: 'warning',
  });
  return import(pathToFileURL(outfile).href);
}

/** Without members that say nothing. */
function stripped(json) {
  return Object.fromEntries(
    Object.entries(json).filter(
      ([name, value]) =>
        name !== 'status' &&
        value !== '' &&
        value !== null &&
        !(Array.isArray(value) && value.length === 0),
    ),
  );
}
