/** Topics, below the id of a page, on which it tells its state and what its preflight found. [EX-49] [EX-56] [AC-30] */
const OF_PAGES = ['page_state', 'graph_editor/presence', 'preflight'];

/** Whether a page tells others of itself there: recorded only where a selection names it. [RC-12] */
export function isInternalTopic(topic: string, publisherId: string): boolean {
  return OF_PAGES.some((rest) => topic === `/${publisherId}/${rest}`);
}
