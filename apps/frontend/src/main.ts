import './styles/index.css';
import { createApp } from 'vue';
import { createRouter, createWebHistory } from 'vue-router';
import App from './App.vue';
import { CONNECTION } from './connection/connection.ts';
import { createConnection } from './connection/create-connection.ts';
import { routes } from './routes.ts';
import { createToasts, provideToasts } from './ui/toasts/toasts.ts';

const app = createApp(App);
const router = createRouter({ history: createWebHistory(), routes });
const connection = app.runWithContext(() => createConnection());

app.use(router);
app.provide(CONNECTION, connection);
provideToasts(app, createToasts());
app.mount('#app');
connection.connect();
