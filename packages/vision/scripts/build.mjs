import { join } from 'node:path';
import { writeAssetSets } from './asset-sets.mjs';
import { buildLibrary } from './library.mjs';

const dist = join(import.meta.dirname, '..', 'dist');
await buildLibrary(join(dist, 'vision.js'));
writeAssetSets(join(dist, 'assets'));
