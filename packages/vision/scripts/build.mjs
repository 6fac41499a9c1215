import { join } from 'node:path';
import { writeAssetSets } from './asset-sets.mjs';
import { buildLibrary } from './library.mjs';

const dist = join(import.meta.dirname, '..', 'dist');
const library = join(dist, 'vision.js');
await buildLibrary(library);
writeAssetSets(join(dist, 'assets'), library);
