/** What a session can take from a page: its pointer, its clicks, its keys. */
export type InputName = 'pointer' | 'pressed' | 'escape' | 'key';
