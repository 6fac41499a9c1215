import { MasterProcess } from '@ubii/harness';
import type { Part } from '../parts/shared-parts.ts';
import { IN_CHROMIUM } from '../browser/in-chromium.ts';
import type { Workload } from '../measuring/workload.ts';
import { listFigures, listSubject, measureList } from './measure-list.ts';
import { serveBareList, startListBrowser, type ListPage } from './topics-page.ts';

const REFERENCE = 'bare list';

/** A page of the master with a long list, and what fills it. */
interface ListPagePlan {
  /** Of the workload; without `-page` it is also the path of the page. */
  readonly name: 'clients-page' | 'topics-page';
  readonly title: string;
  /** Label of the figure for opening the page. */
  readonly opened: string;
  readonly updatesHz: number;
  fill(url: string): Promise<Part & { readonly published: number }>;
  /** Settles once everything is on the page. */
  whenThere(list: ListPage): Promise<void>;
}

/** A page with a long list, seen and scrolled, beside a plain list of numbers. */
export function listPageWorkload(plan: ListPagePlan): Workload {
  const { name, title, opened, updatesHz, fill, whenThere } = plan;
  const what = name.replace('-page', '');
  const subject = `${what} page`;
  return {
    name,
    group: name,
    title,
    figures: listFigures(subject, opened),
    reference: REFERENCE,
    ...IN_CHROMIUM,
    open: async ({ parts, master: file, profileDir }) => {
      const master = await parts.get('master', () =>
        MasterProcess.start({ program: file, profileDir }),
      );
      const content = await parts.get(what, () => fill(master.url));
      const browser = await parts.get('browser', startListBrowser);
      const bare = await parts.get('bare list', serveBareList);
      const url = `${master.url.replace(/\/$/, '')}/${what}`;
      const load = {
        get published() {
          return content.published;
        },
        updatesHz,
        whenThere,
      };
      return [
        listSubject(REFERENCE, (options) =>
          measureList(browser, bare.url, undefined, master.pid, options),
        ),
        listSubject(subject, (options) => measureList(browser, url, load, master.pid, options)),
      ];
    },
  };
}
