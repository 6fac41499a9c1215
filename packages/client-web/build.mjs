import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { precompress } from '../../scripts/lib/precompress.mjs';
import { bundleForPackage, bundleForPages } from './packaging/bundle-code.mjs';
import { bundleTypes } from './packaging/bundle-types.mjs';
import { describeLicences } from './packaging/describe-licences.mjs';
import { ENTRIES, publishedManifest } from './packaging/manifest.mjs';
import { packFolder } from './packaging/pack-folder.mjs';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

// `package` is what the archive has in it, `sdk` is what a master serves under /sdk/.
const outdir = inPackage(process.argv[2] ?? 'dist');
const packageDir = join(outdir, 'package');
const sdkDir = join(outdir, 'sdk');
rmSync(outdir, { recursive: true, force: true });
mkdirSync(sdkDir, { recursive: true });

const manifest = JSON.parse(readFileSync(inPackage('package.json'), 'utf8'));
const [bundled] = await Promise.all([
  bundleForPackage(packageDir),
  bundleForPages(join(sdkDir, 'ubii-client.js')),
  bundleTypes(ENTRIES, packageDir),
]);
const licences = describeLicences(bundled);
const write = (name, text) => writeFileSync(join(packageDir, name), text);
write('package.json', `${JSON.stringify(publishedManifest(manifest), undefined, 2)}\n`);
write('THIRD-PARTY-LICENCES.txt', licences);
cpSync(inPackage('../../LICENSE'), join(packageDir, 'LICENSE'));
cpSync(inPackage('../../docs/guides/a-program.md'), join(packageDir, 'README.md'));

cpSync(join(packageDir, 'index.d.ts'), join(sdkDir, 'ubii-client.d.ts'));
writeFileSync(join(sdkDir, 'licences.txt'), licences);
writeFileSync(join(sdkDir, `ubii-client-${manifest.version}.tgz`), packFolder(packageDir));
await precompress(sdkDir);
