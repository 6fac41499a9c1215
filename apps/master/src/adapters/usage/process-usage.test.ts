import { resourceUsageSuite } from '../../testing/acceptance/index.ts';
import { ProcessUsage } from './process-usage.ts';

resourceUsageSuite('ProcessUsage', () => new ProcessUsage());
