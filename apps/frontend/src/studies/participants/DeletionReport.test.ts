// @vitest-environment happy-dom
import { fromJson } from '@ubii/proto';
import { mount, RouterLinkStub } from '@vue/test-utils';
import { expect, it } from 'vitest';
import DeletionReport from './DeletionReport.vue';

function reportOf(json: object) {
  const deletion = fromJson('ubii.extension.StudyDeletion', { runCount: 1, ...json });
  return mount(DeletionReport, {
    props: { code: 'P01', deletion },
    global: { stubs: { RouterLink: RouterLinkStub } },
  });
}

it('the report of a deletion links recordings of the same time that stay', () => {
  const report = reportOf({ otherRecordings: [{ id: 'a7', name: 'By hand' }] });
  const others = report.get('ul[aria-label="Other recordings of the same time"]');
  expect(others.text()).toBe('By hand');
  expect(others.getComponent(RouterLinkStub).props('to')).toEqual({ path: '/recordings/a7' });
  expect(reportOf({}).find('ul').exists()).toBe(false);
});
