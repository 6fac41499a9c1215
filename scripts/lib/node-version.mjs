import { readFileSync } from 'fs';

/** Ends the process with one sentence when this Node is older than `engines` of package.json asks for. */
export function requireNode() {
  const manifest = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));
  const wanted = manifest.engines.node.replace('>=', '');
  const [major, minor] = wanted.split('.').map(Number);
  const [ourMajor, ourMinor] = process.versions.node.split('.').map(Number);
  if (ourMajor > major || (ourMajor === major && ourMinor >= minor)) return;
  process.stderr.write(
    `Ubi-Interact needs Node ${wanted} or newer, this is Node ${process.versions.node}: install a newer one from https://nodejs.org and try again.\n`,
  );
  process.exit(1);
}
