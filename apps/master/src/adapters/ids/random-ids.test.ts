import { idSourceSuite } from '../../testing/acceptance/index.ts';
import { randomIds } from './random-ids.ts';

idSourceSuite('randomIds', () => randomIds);
