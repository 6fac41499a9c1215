/** MIME type of a dragged topic. */
const TYPE = 'application/x-ubii-topic';

export function dragTopic({ dataTransfer }: DragEvent, topic: string): void {
  if (!dataTransfer) return;
  dataTransfer.setData(TYPE, topic);
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

export function droppedTopic(event: DragEvent): string | undefined {
  const topic = event.dataTransfer?.getData(TYPE) ?? '';
  if (topic === '') return undefined;
  event.preventDefault();
  return topic;
}
