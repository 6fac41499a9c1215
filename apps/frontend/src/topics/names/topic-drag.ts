/** MIME types of a dragged topic, and of the path of one number in its values. */
const TYPE = 'application/x-ubii-topic';
const PATH_TYPE = 'application/x-ubii-path';

/** @param path of one number in the values of the topic, such as a line of a plot has */
export function dragTopic({ dataTransfer }: DragEvent, topic: string, path?: string): void {
  if (!dataTransfer) return;
  dataTransfer.setData(TYPE, topic);
  // Empty data is not kept: a slash stands for the value itself.
  if (path !== undefined) dataTransfer.setData(PATH_TYPE, `/${path}`);
  dataTransfer.setData('text/plain', topic);
  dataTransfer.effectAllowed = 'copy';
}

/** Whether a topic is dragged; if so, allows the drop. */
export function acceptTopic(event: DragEvent): boolean {
  if (!event.dataTransfer?.types.includes(TYPE)) return false;
  event.preventDefault();
  event.dataTransfer.dropEffect = 'copy';
  return true;
}

/** Returns the dropped topic, and the path when one number of it was dragged. */
export function droppedTopic(
  event: DragEvent,
): { readonly topic: string; readonly path: string | undefined } | undefined {
  const topic = event.dataTransfer?.getData(TYPE) ?? '';
  if (topic === '') return undefined;
  event.preventDefault();
  const path = event.dataTransfer?.getData(PATH_TYPE) ?? '';
  return { topic, path: path === '' ? undefined : path.slice(1) };
}
