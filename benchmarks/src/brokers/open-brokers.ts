import type {
  Measurement,
  MeasureOptions,
  Subject,
  WorkloadSetting,
} from '../measuring/workload.ts';
import { startRawWs } from './raw-ws.ts';
import type { Target } from './target.ts';
import { startUbii } from './ubii.ts';

/** Every broker with every kind of client, as subjects of one workload. */
export async function brokerSubjects(
  { parts, master, profileDir }: WorkloadSetting,
  measure: (target: Target, options: MeasureOptions) => Promise<Measurement>,
): Promise<Subject[]> {
  const rawWs = await parts.get('raw-ws', () => startRawWs(profileDir));
  const ubii = await parts.get('ubii', () => startUbii(master, profileDir));
  return [...rawWs.targets, ...ubii.targets].map((target) => ({
    name: target.name,
    pids: target.pids,
    measure: (options) => measure(target, options),
  }));
}
