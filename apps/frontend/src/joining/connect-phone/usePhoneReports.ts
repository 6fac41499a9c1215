import { onScopeDispose, shallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { PREFLIGHT_TOPICS, readReport, type PreflightReport } from '../join/preflight/report.ts';

/** More phones than a master accepts: bounds the list against a hostile publisher. */
const MAX_REPORTS = 2000;

/** Returns the preflight reports of phones, by client id. [AC-30] */
export function usePhoneReports() {
  const { client } = useConnection();
  const reports = shallowRef<ReadonlyMap<string, PreflightReport>>(new Map());
  const subscription = client
    .subscribe({ glob: PREFLIGHT_TOPICS }, { format: 'string' })
    .onRecord(({ topic, value }) => {
      const id = topic.split('/')[1] ?? '';
      const report = readReport(value);
      if (report === undefined || reports.value.size >= MAX_REPORTS) return;
      reports.value = new Map(reports.value).set(id, report);
    });
  onScopeDispose(() => void subscription.close());
  return reports;
}
