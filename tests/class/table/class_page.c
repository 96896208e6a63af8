// index.html: the class at a glance. One file; a script sorts its rows.
#include "judge/report/text.h"
#include "class/table/class_table.h"

#include <stdlib.h>
#include <string.h>

// Every byte but the harmless ones as %XX.
void page_link(FILE *stream, const char *path)
{
    for (; *path; path++)
        if (strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-/.", *path))
            fputc(*path, stream);
        else
            fprintf(stream, "%%%02X", (unsigned char)*path);
}

static const char style[] =
    "<style>body{font:15px/1.4 system-ui,sans-serif;margin:2em;color:#222;background:#fff}table{border-collapse:collapse}"
    "th,td{padding:.15em .5em;border-bottom:1px solid #ddd;text-align:left;vertical-align:top}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}td.m{font-family:monospace;white-space:pre}"
    ".bar{background:#8cb4e8;height:.8em}h2{margin-top:2em}#all th{cursor:pointer}.kinds{display:flex;flex-wrap:wrap;gap:1.5em}"
    "figure{margin:0;width:16em}figure .bar{height:.4em}figure img{width:100%;margin-top:.5em}"
    "img{max-width:100%}details{max-width:34em}summary{cursor:pointer}"
    "@media(prefers-color-scheme:dark){body{color:#ddd;background:#181818}a{color:#8cb4e8}th,td{border-color:#444}}</style>\n";

void page_begin(FILE *stream, const char *title)
{
    fprintf(stream,
            "<!DOCTYPE html>\n<html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width\">"
            "<title>%s</title>\n%s",
            title, style);
}

// A click on a heading sorts by it, numbers as numbers, and another click turns the order round; the field leaves only
// the rows that hold a word. Of many rows a browser is given the first alone: it would take long over the rest.
#define SHOWN_ROWS 500
static const char script[] =
    "<script>const t=document.getElementById('all'),b=t.tBodies[0],rows=[...b.rows];let by=-1,word='';"
    "const show=()=>b.replaceChildren(...rows.filter(r=>r.textContent.toLowerCase().includes(word)).slice(0,%d));show();b.hidden=false;"
    "t.tHead.addEventListener('click',e=>{const th=e.target.closest('th');if(!th)return;const c=th.cellIndex,up=by===c;by=up?-1:c;"
    "const k=new Map(rows.map(r=>[r,r.cells[c].dataset.n||r.cells[c].textContent])),o=new Intl.Collator();"
    "rows.sort((x,y)=>{const a=k.get(x),b=k.get(y),d=a-b;return(isNaN(d)?o.compare(a,b):d)*(up?-1:1)});show()});"
    "for(const h of t.tHead.rows[0].cells){h.tabIndex=0;h.addEventListener('keydown',e=>{if(e.key==='Enter')h.click()})}"
    "addEventListener('beforeprint',()=>document.querySelectorAll('details').forEach(d=>d.open=true));"
    "document.getElementById('find').addEventListener('input',e=>{word=e.target.value.toLowerCase();show()})</script>\n";

static const char *mark_of(const char *status)
{
    for (size_t i = 0; i < STATUSES; i++)
        if (strcmp(status, status_table[i].name) == 0)
            return status_table[i].mark;
    return "";
}

size_t count_rows(const Table *table, size_t step, Status status)
{
    size_t count = 0;
    for (size_t r = 0; r < table->count; r++)
        count += strcmp(table->rows[r].student->steps[step].status, status_table[status].name) == 0;
    return count;
}

static void write_overview(FILE *stream, const Table *table)
{
    fputs("<h2>Steps</h2>\n<table><tr><th>step<th>passed<th>wrong<th>broke off<th>not started<th></tr>\n", stream);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!stage_counts(table, step_table[i].stage))
            continue;
        size_t pass = count_rows(table, i, STATUS_PASS), fail = count_rows(table, i, STATUS_FAIL);
        size_t error = count_rows(table, i, STATUS_ERROR);
        fprintf(
            stream,
            "<tr><td><a href=\"lecture.html#s%s\">%s</a> %s<td class=n>%zu<td class=n>%zu<td class=n>%zu<td class=n>%zu"
            "<td style=\"width:12em\"><div class=bar style=\"width:%.0f%%\"></div></tr>\n",
            step_table[i].id, step_table[i].id, step_table[i].title, pass, fail, error,
            table->count - pass - fail - error, table->count ? 100.0 * (double)pass / (double)table->count : 0.0);
    }
    fputs("</table>\n", stream);
}

static void link_student(FILE *stream, const Student *student)
{
    if (student->has_page) {
        fputs("<a href=\"", stream);
        page_link(stream, student->name);
        fputs("/index.html\">", stream);
    }
    text_markup(stream, student->name);
    fputs(student->has_page ? "</a>" : "", stream);
}

#define SHOWN_MISTAKES 15
#define SHOWN_STUDENTS 12

static void write_mistakes(FILE *stream, const Table *table)
{
    size_t kinds, *who;
    Mistake *mistakes = mistakes_find(table, &kinds, &who);
    if (kinds > 0)
        fputs("<h2>What went wrong most often</h2>\n<p>All of it, by step and without names: "
              "<a href=lecture.html>to open in the lecture</a>.</p>\n"
              "<table><tr><th>how many<th>step<th>looks like<th>who</tr>\n",
              stream);
    for (size_t i = 0; i < kinds && i < SHOWN_MISTAKES; i++) {
        const Mistake *m = &mistakes[i];
        fprintf(stream, "<tr><td class=n>%zu<td>%s<td>", m->count, step_table[m->step].id);
        mistake_write(stream, table, m);
        fputs("<td>", stream);
        for (size_t w = 0; w < m->count && w < SHOWN_STUDENTS; w++) {
            fputs(w > 0 ? ", " : "", stream);
            link_student(stream, table->rows[m->who[w]].student);
        }
        if (m->count > SHOWN_STUDENTS)
            fprintf(stream, " and %zu more", m->count - SHOWN_STUDENTS);
        fputs("</tr>\n", stream);
    }
    fputs(kinds > 0 ? "</table>\n" : "", stream);
    free(mistakes);
    free(who);
}

// The message; folded away what went wrong in each step, which would be too long to stand there.
static void write_note(FILE *stream, const Student *student)
{
    size_t said = 0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        said += *student->steps[i].said != '\0';
    fputs("<td>", stream);
    text_markup(stream, student->message);
    if (said > 0)
        fprintf(stream, "<details><summary>%zu ✗ or !</summary>", said);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (*student->steps[i].said) {
            fprintf(stream, "%s: ", step_table[i].id);
            text_markup(stream, student->steps[i].said);
            fputs(--said > 0 ? "<br>" : "</details>", stream);
        }
}

static bool is_shown(const Roster *roster, size_t column)
{
    return column < 4 || column == roster->column; // course systems have many more
}

static void write_student(FILE *stream, const Table *table, const TableRow *row)
{
    const Student *s = row->student;
    const Csv *roster = &table->roster.csv;
    fputs("<tr>", stream);
    for (size_t c = 0; c < roster->columns; c++)
        if (is_shown(&table->roster, c)) {
            fputs("<td>", stream);
            text_markup(stream, row->roster_row ? csv_cell(roster, row->roster_row, c) : "");
        }
    fputs("<td>", stream);
    link_student(stream, s);
    fprintf(stream, "<td>%s%s%s<td class=n>%.1f", s->status, roster->rows && !s->in_roster ? ", not in the roster" : "",
            s->late > 0.0 ? ", late" : "", s->points);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!stage_counts(table, step_table[i].stage))
            continue;
        if (i == 0 || step_table[i].stage != step_table[i - 1].stage)
            fprintf(stream, "<td class=m data-n=%.4g>", s->stage_points[step_table[i].stage - 1]);
        fputs(s->steps[i].there ? mark_of(s->steps[i].status) : " ", stream);
    }
    write_note(stream, s);
    fputs("</tr>\n", stream);
}

static void write_students(FILE *stream, const Table *table)
{
    const Csv *roster = &table->roster.csv;
    fprintf(
        stream,
        "<h2>Submissions</h2>\n<p><input id=find placeholder=\"only rows with …\"> A heading sorts, by a click or the return key; at the right "
        "what went wrong unfolds, all of it when this page is printed.%s</p>\n"
        "<noscript><style>#all tbody{display:table-row-group}</style></noscript><table id=all><thead><tr>",
        table->count > SHOWN_ROWS ? " The first 500 that fit are shown." : "");
    for (size_t c = 0; c < roster->columns; c++)
        if (is_shown(&table->roster, c)) {
            fputs("<th>", stream);
            text_markup(stream, csv_cell(roster, 0, c));
        }
    fputs("<th>submission<th>status<th>points", stream);
    for (int i = 1; i <= STAGE_COUNT; i++)
        if (stage_counts(table, i))
            fprintf(stream, "<th>stage %d", i);
    fputs("<th>remarks</tr></thead>\n<tbody hidden>\n", stream);
    for (size_t r = 0; r < table->count; r++)
        write_student(stream, table, &table->rows[r]);
    fputs("</tbody></table>\n", stream);
    fprintf(stream, script, SHOWN_ROWS);
}

void page_write(FILE *stream, const Table *table)
{
    double sum = 0.0;
    size_t graded = 0;
    for (size_t r = 0; r < table->count; r++) {
        graded += strcmp(table->rows[r].student->status, "graded") == 0;
        sum += table->rows[r].student->points;
    }
    page_begin(stream, "photonlab: the class");
    fprintf(stream,
            "<h1>The class</h1>\n<p>%zu lines, %zu graded; mean of all %.1f points. Points as numbers: "
            "<a href=class.csv>class.csv</a>. ✓ passed, ✗ wrong, ! broke off, ○ not started.</p>\n",
            table->count, graded, table->count ? sum / (double)table->count : 0.0);
    page_write_spread(stream, table);
    write_overview(stream, table);
    write_mistakes(stream, table);
    write_students(stream, table);
    fputs("</html>\n", stream);
}
