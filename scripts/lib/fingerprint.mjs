import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';

import { cacheFolder, inRoot } from './repository.mjs';

const notInputs = /^(node_modules|dist|\.cache(-[a-z-]+)?|test|tests)$|\.test\.ts$|\.md$/;

/**
 * Hash of the names and contents of files, whatever their dates.
 *
 * @param {readonly string[]} paths files and folders, relative to the root; those that do not exist are left out
 */
export function fingerprint(paths) {
  const hash = createHash('sha256');
  for (const path of paths) addPath(hash, path);
  return hash.digest('hex');
}

/** @param {import('node:crypto').Hash} hash @param {string} path */
function addPath(hash, path) {
  const absolute = inRoot(path);
  if (!existsSync(absolute)) return;
  if (statSync(absolute).isDirectory()) {
    for (const name of readdirSync(absolute).sort()) {
      if (!notInputs.test(name)) addPath(hash, join(path, name));
    }
  } else {
    const content = readFileSync(absolute);
    hash.update(`${path}\0${content.length}\0`).update(content);
  }
}

/** @param {string} name what was made */
export function readStamp(name) {
  const file = join(cacheFolder, 'stamps', name);
  return existsSync(file) ? readFileSync(file, 'utf8') : undefined;
}

/** @param {string} name what was made @param {string | undefined} stamp undefined while it is being made */
export function writeStamp(name, stamp) {
  const folder = join(cacheFolder, 'stamps');
  if (stamp === undefined) return rmSync(join(folder, name), { force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, name), stamp);
}
