/** Name of the part of a folder that has its own files, not those of folders in it. */
const OWN_FILES = '.';

/**
 * Folders whose own files import folders in them that import those files. They were there when the check was made: the
 * list only becomes shorter.
 */
export const KNOWN_CIRCLES = [
  'apps/bridge/src/core',
  'apps/frontend/src/bridges',
  'apps/frontend/src/devices',
  'apps/frontend/src/devices/camera',
  'apps/frontend/src/examples',
  'apps/frontend/src/examples/gallery',
  'apps/frontend/src/graph/canvas',
  'apps/frontend/src/graph/editor',
  'apps/frontend/src/graph/model',
  'apps/frontend/src/home',
  'apps/frontend/src/settings',
  'apps/frontend/src/shell',
  'apps/frontend/src/studies',
  'apps/frontend/src/topics/viewers',
  'apps/frontend/src/topics/viewers/space',
  'apps/frontend/src/ui',
  'apps/master/src',
  'apps/master/src/adapters/services',
  'apps/master/src/core/sessions',
  'apps/node/src',
  'benchmarks/src',
  'demos/ubi-party/src/net',
  'demos/ubi-party/src/phone',
  'demos/ubi-party/src/screen',
  'demos/ubi-party/src/sim',
  'demos/ubi-party/src/view',
  'packages/client-web/src',
  'packages/modules/src',
  'packages/patterns/src',
  'packages/pm-sandbox/src',
  'packages/proto/src',
  'packages/recording/src/export',
  'packages/recording/src/import',
  'packages/vision/src',
  'robustness/src/attack',
  'robustness/src/faults',
  'robustness/src/fuzz',
];

/**
 * @typedef {object} ReadModule as dependency-cruiser reports it
 * @property {string} source path of the file from the root
 * @property {readonly { resolved: string }[]} dependencies
 */

/**
 * Finds folders that import each other in a circle. A folder counts with all that is in it, so that a child does not
 * hide its parent. For each folder, the folders in it must import each other in one direction, and so must its own files
 * and these folders, unless the folder is in the list of known ones.
 *
 * @param {readonly ReadModule[]} modules
 * @param {readonly string[]} [known] folders whose own files may be part of a circle
 * @returns {string[]} one sentence for each circle, and for each known folder without one
 */
export function findFolderCircles(modules, known = KNOWN_CIRCLES) {
  const sentences = [];
  const mended = new Set(known);
  for (const [folder, arrows] of arrowsByFolder(modules)) {
    const withOwnFiles = circlesOf(arrows);
    if (withOwnFiles.some((circle) => circle.includes(OWN_FILES))) mended.delete(folder);
    const circles = known.includes(folder) ? circlesOf(withoutOwnFiles(arrows)) : withOwnFiles;
    for (const circle of circles) {
      const parts = circle.sort().map((part) => (part === OWN_FILES ? 'its own files' : part));
      sentences.push(
        `In ${folder} these import each other in a circle: ${parts.join(', ')}. Move what they need to a folder below them.`,
      );
    }
  }
  for (const folder of mended) {
    sentences.push(`${folder} has no circle: delete it from KNOWN_CIRCLES.`);
  }
  return sentences.sort();
}

/** @param {readonly ReadModule[]} modules */
function arrowsByFolder(modules) {
  const sources = new Set(modules.map(({ source }) => source));
  /** @type {Map<string, Map<string, Set<string>>>} */
  const folders = new Map();
  for (const { source, dependencies } of modules) {
    for (const { resolved } of dependencies) {
      if (sources.has(resolved)) addArrow(folders, source, resolved);
    }
  }
  return folders;
}

/**
 * Notes an import in the folder where the paths of both files part.
 *
 * @param {Map<string, Map<string, Set<string>>>} folders
 * @param {string} from
 * @param {string} to
 */
function addArrow(folders, from, to) {
  const [own, other] = [from.split('/'), to.split('/')];
  let depth = 0;
  while (depth < own.length - 1 && depth < other.length - 1 && own[depth] === other[depth]) depth++;
  const partOf = (/** @type {string[]} */ path) =>
    path.length - 1 === depth ? OWN_FILES : String(path[depth]);
  const [start, end] = [partOf(own), partOf(other)];
  if (start === end) return;
  const folder = own.slice(0, depth).join('/');
  const arrows = folders.get(folder) ?? new Map();
  folders.set(folder, arrows.set(start, (arrows.get(start) ?? new Set()).add(end)));
}

/** @param {ReadonlyMap<string, ReadonlySet<string>>} arrows */
function withoutOwnFiles(arrows) {
  return new Map(
    [...arrows]
      .filter(([part]) => part !== OWN_FILES)
      .map(([part, ends]) => [part, new Set([...ends].filter((end) => end !== OWN_FILES))]),
  );
}

/**
 * Groups of parts that reach each other.
 *
 * @param {ReadonlyMap<string, ReadonlySet<string>>} arrows
 */
function circlesOf(arrows) {
  const reached = new Map([...arrows.keys()].map((part) => [part, reachable(arrows, part)]));
  /** @type {string[][]} */
  const circles = [];
  for (const [part, ends] of reached) {
    if (!ends.has(part) || circles.some((circle) => circle.includes(part))) continue;
    circles.push([...ends].filter((end) => reached.get(end)?.has(part)));
  }
  return circles;
}

/**
 * @param {ReadonlyMap<string, ReadonlySet<string>>} arrows
 * @param {string} start
 */
function reachable(arrows, start) {
  /** @type {Set<string>} */
  const found = new Set();
  const open = [start];
  for (let part = open.pop(); part !== undefined; part = open.pop()) {
    for (const end of arrows.get(part) ?? []) {
      if (found.has(end)) continue;
      found.add(end);
      open.push(end);
    }
  }
  return found;
}
