import { computed, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { PREFLIGHT_TOPICS, readReport, type PreflightReport } from '../join/preflight/report.ts';

/** Returns the preflight reports of phones, by client id. [AC-30] */
export function usePhoneReports(): ComputedRef<ReadonlyMap<string, PreflightReport>> {
  const { byTopic } = useTopic({ glob: PREFLIGHT_TOPICS }, { format: 'string' });
  return computed(() => {
    const reports = new Map<string, PreflightReport>();
    for (const { topic, value } of byTopic.value.values()) {
      const report = readReport(value);
      if (report !== undefined) reports.set(topic.split('/')[1] ?? '', report);
    }
    return reports;
  });
}
