import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

const BLOCK = 512;
/** As `npm pack` dates files: 26 October 1985. */
const MODIFIED_S = 499162500;
/** Byte of a gzip header for the system; 255 is unknown (RFC 1952, section 2.3.1). */
const GZIP_SYSTEM = 9;

/**
 * Packs a folder as npm does, with the same bytes for the same files.
 *
 * @param {string} folder absolute
 * @returns {Buffer} tar archive, compressed with gzip
 */
export function packFolder(folder) {
  const names = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(folder.length + 1))
    .map((name) => name.replaceAll('\\', '/'))
    .sort();
  const files = names.flatMap((name) => {
    const content = readFileSync(join(folder, name));
    const padding = Buffer.alloc((BLOCK - (content.length % BLOCK)) % BLOCK);
    return [headerOf(`package/${name}`, content.length), content, padding];
  });
  const packed = gzipSync(Buffer.concat([...files, Buffer.alloc(2 * BLOCK)]), { level: 9 });
  packed[GZIP_SYSTEM] = 255;
  return packed;
}

/** Header of a file in the format ustar (POSIX.1-1988). */
function headerOf(name, sizeBytes) {
  if (Buffer.byteLength(name) > 100) throw new Error(`${name} is longer than 100 bytes.`);
  const header = Buffer.alloc(BLOCK);
  const octal = (value, digits) => `${value.toString(8).padStart(digits, '0')}\0`;
  header.write(name, 0);
  header.write(octal(0o644, 7), 100);
  header.write(octal(0, 7), 108);
  header.write(octal(0, 7), 116);
  header.write(octal(sizeBytes, 11), 124);
  header.write(octal(MODIFIED_S, 11), 136);
  header.write(' '.repeat(8), 148);
  header.write('0', 156);
  header.write('ustar\x0000', 257);
  const sum = header.reduce((total, byte) => total + byte, 0);
  header.write(`${sum.toString(8).padStart(6, '0')}\0 `, 148);
  return header;
}
