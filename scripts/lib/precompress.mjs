import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';

const compressible = new Set([
  '.html',
  '.js',
  '.mjs',
  '.css',
  '.svg',
  '.json',
  '.webmanifest',
  '.txt',
  '.wasm',
  '.map',
]);

/** Below this a compressed copy saves less than the extra file costs. */
const SMALLEST_BYTES = 1024;

/**
 * Writes a brotli and a gzip copy beside every file of a folder that gets smaller by it.
 *
 * @param {string} folder absolute
 */
export async function precompress(folder) {
  const entries = readdirSync(folder, { withFileTypes: true, recursive: true });
  await Promise.all(
    entries
      .filter((entry) => entry.isFile() && compressible.has(extname(entry.name)))
      .map((entry) => compressFile(join(entry.parentPath ?? entry.path, entry.name))),
  );
}

/** @param {string} file */
async function compressFile(file) {
  const content = readFileSync(file);
  if (content.length < SMALLEST_BYTES) return;
  const brotli = await promisify(brotliCompress)(content, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: 9,
      [constants.BROTLI_PARAM_SIZE_HINT]: content.length,
    },
  });
  const zipped = await promisify(gzip)(content, { level: 9 });
  if (brotli.length < content.length) writeFileSync(`${file}.br`, brotli);
  if (zipped.length < content.length) writeFileSync(`${file}.gz`, zipped);
}
