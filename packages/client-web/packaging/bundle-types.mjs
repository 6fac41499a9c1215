import { execFile } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { rolldown } from 'rolldown';
import { dts } from 'rolldown-plugin-dts';

import { programFile, readJson } from '../../../scripts/lib/repository.mjs';

const packages = fileURLToPath(new URL('../../', import.meta.url));
const here = join(packages, 'client-web');

/**
 * Writes the types of each entry as one file without imports: declarations of all files by the compiler, then bundled.
 *
 * @param {Record<string, string>} entries sources by name of the built file
 * @param {string} outdir
 */
export async function bundleTypes(entries, outdir) {
  const declarations = mkdtempSync(join(tmpdir(), 'ubii-types-'));
  try {
    const tsc = programFile('packages/client-web', 'typescript', 'tsc');
    const args = ['-p', join(here, 'tsconfig.package.json'), '--outDir', declarations];
    await promisify(execFile)(process.execPath, [tsc, ...args]).catch(({ stdout, message }) => {
      throw new Error(`The types of the client library are not built: ${stdout || message}`);
    });
    for (const [name, source] of Object.entries(entries)) {
      const bundle = await rolldown({
        input: { [name]: declarationOf(declarations, join('client-web', source)) },
        checks: { bundlerTimings: false },
        plugins: [
          ownDeclarations(declarations),
          dts({ dtsInput: true, emitDtsOnly: true, tsconfig: false, sourcemap: false }),
        ],
      });
      await bundle.write({ dir: outdir, entryFileNames: '[name].ts' });
      await bundle.close();
    }
  } finally {
    rmSync(declarations, { recursive: true, force: true });
  }
}

/** Finds the declarations of a source; other packages stay imports, which a test refuses. */
function ownDeclarations(declarations) {
  return {
    name: 'ubii-declarations',
    resolveId: {
      order: 'pre',
      handler(id, importer) {
        if (importer === undefined) return null;
        if (id.startsWith('.')) return resolve(dirname(importer), id).replace(/\.ts$/, '.d.ts');
        const [, name, path = ''] = /^@ubii\/([^/]+)(\/.*)?$/.exec(id) ?? [];
        if (name === undefined) return { id, external: true };
        const { exports } = readJson(join(packages, name, 'package.json'));
        return declarationOf(declarations, join(name, exports[`.${path}`]));
      },
    },
  };
}

/** @param {string} source path below `packages` */
function declarationOf(declarations, source) {
  return join(declarations, source).replace(/\.ts$/, '.d.ts');
}
