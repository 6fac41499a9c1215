import { brotliCompressSync, constants } from 'node:zlib';

/**
 * Maximum size of the JavaScript that Home loads on a new installation, compressed with brotli as the master serves it,
 * headers included, bytes.
 */
export const MAX_FIRST_LOAD_BYTES = 200_000;

const HOME = /\/home\/HomePage\.vue$/;
/** What the headers of one file take, bytes. */
const HEADER_BYTES = 1500;
/** As in scripts/lib/precompress.mjs. */
const QUALITY = 9;

/**
 * @typedef {object} Chunk
 * @property {'chunk'} type
 * @property {string} fileName
 * @property {string} code
 * @property {boolean} isEntry
 * @property {string | null} facadeModuleId
 * @property {readonly string[]} imports filenames of chunks that it imports at once
 */

/**
 * Returns the chunks that a cold load of Home takes: the entry, Home, and all that they import at once, with their
 * compressed sizes and headers, largest first.
 *
 * @param {Readonly<Record<string, Chunk | { type: 'asset' }>>} bundle
 * @returns {{ fileName: string, bytes: number }[]}
 */
export function firstLoad(bundle) {
  const chunks = Object.values(bundle).filter((one) => one.type === 'chunk');
  const waiting = chunks
    .filter(({ isEntry, facadeModuleId }) => isEntry || HOME.test(facadeModuleId ?? ''))
    .map(({ fileName }) => fileName);
  if (waiting.length < 2) throw new Error('The build has no entry or no chunk of Home.');
  const files = new Set(waiting);
  for (const fileName of files) {
    const chunk = bundle[fileName];
    if (chunk?.type === 'chunk') for (const one of chunk.imports) files.add(one);
  }
  return chunks
    .filter(({ fileName }) => files.has(fileName))
    .map(({ fileName, code }) => ({ fileName, bytes: compressedBytes(code) + HEADER_BYTES }))
    .sort((a, b) => b.bytes - a.bytes);
}

/** @param {string} code */
function compressedBytes(code) {
  const params = { [constants.BROTLI_PARAM_QUALITY]: QUALITY };
  return brotliCompressSync(code, { params }).length;
}

/**
 * Vite plugin: fails the build when the first load of Home grows beyond its limit, and names the largest files.
 *
 * @returns {import('vite').Plugin}
 */
export function firstLoadPlugin() {
  return {
    name: 'ubii-first-load',
    apply: 'build',
    writeBundle(_options, bundle) {
      const files = firstLoad(/** @type {Parameters<typeof firstLoad>[0]} */ (bundle));
      const total = files.reduce((sum, { bytes }) => sum + bytes, 0);
      const text = `First load of Home: ${(total / 1000).toFixed(1)} of ${MAX_FIRST_LOAD_BYTES / 1000} kB of JavaScript in ${files.length} files.`;
      if (total <= MAX_FIRST_LOAD_BYTES) return this.info(text);
      const largest = files.slice(0, 12).map(({ fileName, bytes }) => `  ${bytes} ${fileName}`);
      this.error(
        `${text} Load what it does not need at once with a dynamic import. The largest:\n${largest.join('\n')}`,
      );
    },
  };
}
