// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { publishReport, readReport } from './report.ts';

function published(checks: Parameters<typeof publishReport>[1]) {
  const records: [string, string][] = [];
  const client = {
    id: 'me',
    publish: (topic: string, _format: string, value: string) => records.push([topic, value]),
  };
  publishReport(client as unknown as Parameters<typeof publishReport>[0], checks);
  return records;
}

it('what is published is what the host reads [AC-30]', () => {
  const [record] = published([
    { id: 'master', state: 'good', title: 'Master reached', text: '', value: '9 ms' },
    { id: 'clock', state: 'checking', title: 'Clock', text: 'Comparing' },
  ]);
  expect(record?.[0]).toBe('/me/preflight');
  expect(readReport(record![1])?.checks).toEqual([
    { id: 'master', state: 'good', title: 'Master reached', text: '', value: '9 ms' },
  ]);
});

it('what is no report is none, and words of others have an end', () => {
  for (const text of ['', 'null', '3', '{}', '{"version":2,"checks":[]}', '{"version":1}']) {
    expect(readReport(text), text).toBeUndefined();
  }
  const long = readReport(
    JSON.stringify({
      version: 1,
      agent: 'x'.repeat(1000),
      checks: [null, 3, { id: 'evil' }, { id: 'clock', state: 'good', title: 7 }],
    }),
  );
  expect(long?.agent).toHaveLength(400);
  expect(long?.checks).toEqual([{ id: 'clock', state: 'good', title: '', text: '', value: '' }]);
});
