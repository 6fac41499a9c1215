/** Whether a page tells its state to other pages there: recorded only where a selection names it. [RC-12] */
export function isInternalTopic(topic: string, publisherId: string): boolean {
  return (
    topic === `/${publisherId}/page_state` || topic === `/${publisherId}/graph_editor/presence`
  );
}
